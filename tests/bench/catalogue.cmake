# Opening, paging and searching a catalogue of 100,000 sherds, and merging two; not a test: run it by
# hand.
add_executable(bench_catalogue_scale catalogue_scale.cpp)
target_link_libraries(bench_catalogue_scale PRIVATE ostraka_exchange ostraka_merge ostraka_flags)
