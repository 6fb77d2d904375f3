#pragma once
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace ostraka::segmentation {

// Just enough of protocol buffers and ONNX to write a network of 1 x 1 convolutions by hand.
inline std::string varint(std::uint64_t v) {
  std::string out;
  for (; v >= 0x80; v >>= 7) out += static_cast<char>(v | 0x80);
  return out + static_cast<char>(v);
}
inline std::string number(int field, std::uint64_t v) {
  return varint(field << 3) + varint(v);
}
inline std::string bytes(int field, const std::string& s) {
  return varint(field << 3 | 2) + varint(s.size()) + s;
}
inline std::string floats(const std::vector<float>& values) {
  std::string raw(values.size() * 4, '\0');
  std::memcpy(raw.data(), values.data(), raw.size());
  return raw;
}
inline std::string tensor(const std::string& name, const std::vector<int>& dims,
                          const std::vector<float>& values) {
  std::string out;
  for (const int d : dims) out += number(1, d);
  return out + number(2, 1) + bytes(8, name) + bytes(9, floats(values));
}
inline std::string valueInfo(const std::string& name, const std::vector<int>& dims) {
  std::string shape;
  for (const int d : dims) shape += bytes(1, d > 0 ? number(1, d) : bytes(2, "n"));
  return bytes(1, name) + bytes(2, bytes(1, number(1, 1) + bytes(2, shape)));
}

inline std::string convolution(const std::string& input, const std::string& weights,
                               const std::string& output, const std::string& attribute = {}) {
  const std::string kernel = bytes(1, "kernel_shape") + number(8, 1) + number(8, 1) + number(20, 7);
  return bytes(1, bytes(1, input) + bytes(1, weights) + bytes(2, output) + bytes(3, output) +
                      bytes(4, "Conv") + bytes(5, kernel) +
                      (attribute.empty() ? "" : bytes(5, attribute)));
}

inline std::string freeInputAndOutput() {
  return bytes(11, valueInfo("x", {1, 3, 0, 0})) + bytes(12, valueInfo("y", {1, 1, 0, 0}));
}

inline std::string modelOf(const std::string& graph) {
  return number(1, 7) + bytes(7, graph) + bytes(8, bytes(1, "") + number(2, 13));
}

}  // namespace ostraka::segmentation
