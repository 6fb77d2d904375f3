#include "segmentation/onnx_file.h"

#include <algorithm>
#include <array>
#include <climits>
#include <set>

#include "base/message.h"

namespace ostraka::segmentation {
namespace {

/// How a field of a protocol buffer message is written. Fields with another type than their
/// number's are passed over by all readers.
enum class Wire : std::uint8_t { Varint = 0, Fixed64 = 1, Bytes = 2, Fixed32 = 5 };

/// One field: a number, or a run of bytes.
struct Field {
  std::uint32_t number = 0;
  Wire wire = Wire::Varint;
  std::uint64_t value = 0;
  std::string_view bytes;

  bool is(std::uint32_t n, Wire w) const { return number == n && wire == w; }
};

std::optional<std::uint64_t> readVarint(std::string_view& text) {
  std::uint64_t value = 0;
  for (int shift = 0; shift < 64 && !text.empty(); shift += 7) {
    const auto byte = static_cast<unsigned char>(text.front());
    text.remove_prefix(1);
    value |= static_cast<std::uint64_t>(byte & 0x7F) << shift;
    if ((byte & 0x80) == 0) return value;
  }
  return std::nullopt;
}

std::optional<Field> readField(std::string_view& text) {
  const auto key = readVarint(text);
  if (!key || *key > UINT32_MAX) return std::nullopt;
  Field field{static_cast<std::uint32_t>(*key >> 3), static_cast<Wire>(*key & 7), 0, {}};
  std::uint64_t length = 0;
  switch (field.wire) {
    case Wire::Varint:
      if (const auto value = readVarint(text))
        field.value = *value;
      else
        return std::nullopt;
      break;
    case Wire::Fixed64:
      length = 8;
      break;
    case Wire::Fixed32:
      length = 4;
      break;
    case Wire::Bytes:
      if (const auto size = readVarint(text))
        length = *size;
      else
        return std::nullopt;
      break;
    default:  // groups, which ONNX does not have
      return std::nullopt;
  }
  if (length > text.size()) return std::nullopt;
  field.bytes = text.substr(0, static_cast<std::size_t>(length));
  text.remove_prefix(field.bytes.size());
  return field;
}

// Calls see for the message's fields in order while it is true; false: not the whole message.
template <class See>
bool eachField(std::string_view text, const See& see) {
  while (!text.empty()) {
    const auto field = readField(text);
    if (!field || !see(*field)) return false;
  }
  return true;
}

// The values of a repeated whole number, one by one or packed.
template <class See>
bool eachWhole(const Field& field, const See& see) {
  if (field.wire == Wire::Varint) return see(field.value);
  if (field.wire != Wire::Bytes) return true;
  for (std::string_view rest = field.bytes; !rest.empty();) {
    const auto value = readVarint(rest);
    if (!value || !see(*value)) return false;
  }
  return true;
}

// ONNX: ValueInfoProto.name = 1, type = 2; TypeProto.tensor_type = 1; Tensor.shape = 2; dim = 1;
// value = 1.
struct ValueInfo {
  std::string_view name;
  InputShape shape;
};
ValueInfo valueInfoOf(std::string_view bytes) {
  ValueInfo info;
  const auto dim = [&](const Field& field) {
    std::int64_t size = -1;
    eachField(field.bytes, [&](const Field& part) {
      if (part.is(1, Wire::Varint)) size = static_cast<std::int64_t>(part.value);
      return true;
    });
    info.shape.push_back(size > 0 ? size : -1);
    return true;
  };
  eachField(bytes, [&](const Field& part) {
    if (part.is(1, Wire::Bytes)) info.name = part.bytes;
    return !part.is(2, Wire::Bytes) || eachField(part.bytes, [&](const Field& type) {
      return !type.is(1, Wire::Bytes) || eachField(type.bytes, [&](const Field& tensor) {
        return !tensor.is(2, Wire::Bytes) || eachField(tensor.bytes, dim);
      });
    });
  });
  return info;
}

/// Of a type of TensorProto: bytes of a value, and the field that holds the values where raw_data
/// does not.
struct TensorType {
  std::uint64_t type, bytes;
  std::uint32_t field;
};
constexpr TensorType kTensorTypes[] = {{1, 4, 4},  {2, 1, 5},   {3, 1, 5},   {4, 2, 5},
                                       {5, 2, 5},  {6, 4, 5},   {7, 8, 7},   {9, 1, 5},
                                       {10, 2, 5}, {11, 8, 10}, {12, 4, 11}, {13, 8, 11}};

/// A setting of a node that OpenCV divides by, or adds to sizes without a look.
struct Setting {
  std::string_view name;
  std::int64_t least;
};
constexpr std::int64_t kMostOfASetting = 4096;
constexpr Setting kSettings[] = {{"group", 1},         {"strides", 1},   {"kernel_shape", 1},
                                 {"dilations", 1},     {"blocksize", 1}, {"pads", -kMostOfASetting},
                                 {"output_padding", 0}};

constexpr int kGraphsWithinEachOther = 8;

// ModelProto.graph = 7; GraphProto.node = 1, initializer = 5; NodeProto.input = 1, output = 2,
// op_type = 4, attribute = 5; AttributeProto.name = 1, i = 3, t = 5, g = 6, ints = 8, tensors = 10,
// graphs = 11.
class OnnxCheck {
 public:
  explicit OnnxCheck(const std::string& where) : where_(where) {}

  Result<void> model(std::string_view bytes) {
    const bool whole = eachField(bytes, [&](const Field& field) {
      return !field.is(7, Wire::Bytes) || graph(field.bytes, 1);
    });
    if (error_) return *error_;
    if (!whole) return damaged();
    return {};
  }

 private:
  Error damaged() const {
    return Error::unusable(
        message("The network's file is damaged; copy it again, or export it again."), where_);
  }
  bool refuse(Message words) {
    error_ = Error::unusable(std::move(words), where_);
    return false;
  }

  bool graph(std::string_view bytes, int depth) {
    if (depth > kGraphsWithinEachOther) return false;
    return eachField(bytes,
                     [&](const Field& field) {
                       return !field.is(5, Wire::Bytes) || initializer(field.bytes);
                     }) &&
           eachField(bytes, [&](const Field& field) {
             return !field.is(1, Wire::Bytes) || node(field.bytes, depth);
           });
  }

  bool initializer(std::string_view bytes) {
    const std::optional<std::uint64_t> values = valuesOf(bytes);
    if (values != std::uint64_t{0}) return values.has_value();
    return eachField(bytes, [&](const Field& field) {
      if (field.is(8, Wire::Bytes)) empty_.insert(field.bytes);
      return true;
    });
  }

  bool node(std::string_view bytes, int depth) {
    std::string_view operation;
    bool reads_nothing = false, gives_nothing = false;
    const bool whole = eachField(bytes, [&](const Field& field) {
      if (field.is(1, Wire::Bytes)) reads_nothing |= empty_.contains(field.bytes);
      if (field.is(4, Wire::Bytes)) operation = field.bytes;
      return !field.is(5, Wire::Bytes) || attribute(field.bytes, depth, gives_nothing);
    });
    if (!whole) return false;
    if (gives_nothing)  // a constant without values
      eachField(bytes, [&](const Field& field) {
        if (field.is(2, Wire::Bytes)) empty_.insert(field.bytes);
        return true;
      });
    return !reads_nothing || (operation != "Conv" && operation != "ConvTranspose");
  }

  bool attribute(std::string_view bytes, int depth, bool& empty) {
    std::string_view name;
    int tensors = 0, graphs = 0;  // of those that are there once: two would be put into one
    const bool whole = eachField(bytes, [&](const Field& field) {
      if (field.is(1, Wire::Bytes)) name = field.bytes;
      if (field.is(5, Wire::Bytes) || field.is(10, Wire::Bytes)) {
        const std::optional<std::uint64_t> values = valuesOf(field.bytes);
        empty |= values == std::uint64_t{0};
        return values && (field.number != 5 || ++tensors == 1);
      }
      if (field.is(6, Wire::Bytes) || field.is(11, Wire::Bytes))
        return graph(field.bytes, depth + 1) && (field.number != 6 || ++graphs == 1);
      return true;
    });
    const auto* setting = std::ranges::find(kSettings, name, &Setting::name);
    if (!whole || setting == std::end(kSettings)) return whole;
    return eachField(bytes, [&](const Field& field) {
      return !(field.is(3, Wire::Varint) || field.number == 8) ||
             eachWhole(field, [&](std::uint64_t value) {
               const auto number = static_cast<std::int64_t>(value);
               return (number >= setting->least && number <= kMostOfASetting) ||
                      refuse(message("A layer of the network has '%1' %2, but only %3 to %4 can "
                                     "be used; use another network.",
                                     name, number, setting->least, kMostOfASetting));
             });
    });
  }

  // How many values a tensor has; nothing where they are not those that its shape says.
  // TensorProto.dims = 1, data_type = 2, the values by their type = 4 to 7, 10 and 11, raw_data =
  // 9, external_data = 13, data_location = 14.
  std::optional<std::uint64_t> valuesOf(std::string_view bytes) {
    std::uint64_t values = 1, type = 0, raw = 0;
    std::array<std::uint64_t, 12> typed{};
    // As many as OpenCV counts; so their bytes do not overflow.
    const auto multiply = [&](std::uint64_t dim) {
      if (dim > INT_MAX) return false;
      values *= dim;
      return values <= INT_MAX;
    };
    const bool whole = eachField(bytes, [&](const Field& field) {
      switch (field.number) {
        case 1:
          return eachWhole(field, multiply);
        case 2:
          if (field.wire == Wire::Varint) type = field.value;
          return true;
        case 4:
          if (field.wire == Wire::Fixed32 || field.wire == Wire::Bytes)
            typed[4] += field.bytes.size() / 4;
          return true;
        case 10:
          if (field.wire == Wire::Fixed64 || field.wire == Wire::Bytes)
            typed[10] += field.bytes.size() / 8;
          return true;
        case 5:
        case 7:
        case 11:
          return eachWhole(field, [&](std::uint64_t) { return ++typed[field.number] > 0; });
        case 9:
          if (field.wire == Wire::Bytes) raw = field.bytes.size();
          return true;
        case 13:
        case 14:
          return (field.number == 14 && field.value == 0) ||
                 refuse(
                     message("The network's weights are in another file; export it as one file."));
        default:
          return true;
      }
    });
    const auto* kind = std::ranges::find(kTensorTypes, type, &TensorType::type);
    if (!whole || kind == std::end(kTensorTypes)) return std::nullopt;
    std::uint64_t all = 0;
    for (const std::uint64_t count : typed) all += count;
    const bool right = all == 0 ? raw == values * kind->bytes
                                : raw == 0 && all == values && typed[kind->field] == values;
    return right ? std::optional(values) : std::nullopt;
  }

  const std::string& where_;
  std::optional<Error> error_;
  std::set<std::string_view> empty_;  ///< tensors without values
};

}  // namespace

// GraphProto.initializer = 5, input = 11; TensorProto.name = 8.
std::optional<InputShape> inputShapeOf(std::string_view model) {
  std::set<std::string_view> weights;
  std::vector<ValueInfo> inputs;
  eachField(model, [&](const Field& graph) {
    return !graph.is(7, Wire::Bytes) || eachField(graph.bytes, [&](const Field& field) {
      if (field.is(11, Wire::Bytes)) inputs.push_back(valueInfoOf(field.bytes));
      return !field.is(5, Wire::Bytes) || eachField(field.bytes, [&](const Field& part) {
        if (part.is(8, Wire::Bytes)) weights.insert(part.bytes);
        return true;
      });
    });
  });
  for (const ValueInfo& input : inputs)
    if (!weights.contains(input.name)) return input.shape;
  return std::nullopt;
}

Result<void> checkOnnx(std::string_view model, const std::string& where) {
  return OnnxCheck(where).model(model);
}

}  // namespace ostraka::segmentation
