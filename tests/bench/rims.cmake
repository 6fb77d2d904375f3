# Rim diameters of virtual sherds against the truth: RESULTS.md, 'Rims'.
add_executable(rim_accuracy rim_accuracy.cpp)
target_link_libraries(rim_accuracy PRIVATE ostraka_drawing ostraka_virtualrig)
