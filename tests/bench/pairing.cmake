# How often the true partner and its pose are among the candidates: RESULTS.md, 'Pairing'.
add_executable(pairing_accuracy pairing_accuracy.cpp)
target_link_libraries(pairing_accuracy PRIVATE ostraka_pairing ostraka_flags)
