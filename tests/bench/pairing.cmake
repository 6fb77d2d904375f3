# How often the true partner and its pose are among the candidates: RESULTS.md, 'Pairing'.
add_executable(pairing_accuracy pairing_accuracy.cpp)
target_link_libraries(pairing_accuracy PRIVATE ostraka_pairing ostraka_flags)
add_executable(register_sets register_sets.cpp)
target_link_libraries(register_sets PRIVATE ostraka_pipeline ostraka_scansets ostraka_review ostraka_flags)
