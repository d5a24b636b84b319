// Numbers, words and texts of a structure as a message's fields, through protobuf's reflection. A
// field whose type does not go with the member's ends the process in protobuf; the tests go through
// all of them. Thread safety: plain values.
#pragma once

#include <google/protobuf/message.h>

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>

namespace gonio::wire {

// Specialised for each enum: `kShift`, its words' numbers on the wire less its own, and `kLast`,
// the last number of the wire's. See words.h.
template <class Enum>
struct Words;

template <class T>
concept Enumeration = std::is_enum_v<T>;
template <class T>
concept Scalar = std::is_arithmetic_v<T> || Enumeration<T> || std::same_as<T, std::string>;

class FieldOf {
 public:
  FieldOf(const google::protobuf::Message& message, int number)
      : reflection_(*message.GetReflection()),
        field_(*message.GetDescriptor()->FindFieldByNumber(number)) {}

  using Message = google::protobuf::Message;

  // One value.
  template <Scalar T>
  void set(Message& to, const T& value) const;
  [[nodiscard]] Message& mutable_message(Message& to) const {
    return *reflection_.MutableMessage(&to, &field_);
  }
  [[nodiscard]] bool is_given(const Message& from) const {
    return reflection_.HasField(from, &field_);
  }
  template <Scalar T>
  [[nodiscard]] T get(const Message& from) const;
  // A word; none for one of a newer server.
  template <Enumeration T>
  [[nodiscard]] std::optional<T> get_known(const Message& from) const;
  [[nodiscard]] const Message& message_in(const Message& from) const {
    return reflection_.GetMessage(from, &field_);
  }

  // A list.
  template <Scalar T>
  void add(Message& to, const T& value) const;
  [[nodiscard]] Message& add_message(Message& to) const {
    return *reflection_.AddMessage(&to, &field_);
  }
  [[nodiscard]] int size(const Message& from) const { return reflection_.FieldSize(from, &field_); }
  template <Scalar T>
  [[nodiscard]] T get_at(const Message& from, int index) const;
  [[nodiscard]] const Message& message_at(const Message& from, int index) const {
    return reflection_.GetRepeatedMessage(from, &field_, index);
  }

 private:
  using Kind = google::protobuf::FieldDescriptor::CppType;

  const google::protobuf::Reflection& reflection_;
  const google::protobuf::FieldDescriptor& field_;
};

template <Scalar T>
void FieldOf::set(Message& to, const T& value) const {
  if constexpr (std::same_as<T, std::string>) {
    reflection_.SetString(&to, &field_, value);
  } else if constexpr (std::same_as<T, bool>) {
    reflection_.SetBool(&to, &field_, value);
  } else if constexpr (std::floating_point<T>) {
    reflection_.SetDouble(&to, &field_, value);
  } else if constexpr (Enumeration<T>) {
    reflection_.SetEnumValue(&to, &field_, static_cast<int>(value) + Words<T>::kShift);
  } else if (field_.cpp_type() == Kind::CPPTYPE_UINT64) {
    reflection_.SetUInt64(&to, &field_, static_cast<std::uint64_t>(value));
  } else if (field_.cpp_type() == Kind::CPPTYPE_UINT32) {
    reflection_.SetUInt32(&to, &field_, static_cast<std::uint32_t>(value));
  } else {
    reflection_.SetInt32(&to, &field_, static_cast<std::int32_t>(value));
  }
}

template <Scalar T>
T FieldOf::get(const Message& from) const {
  if constexpr (std::same_as<T, std::string>) {
    return reflection_.GetString(from, &field_);
  } else if constexpr (std::same_as<T, bool>) {
    return reflection_.GetBool(from, &field_);
  } else if constexpr (std::floating_point<T>) {
    return reflection_.GetDouble(from, &field_);
  } else if constexpr (Enumeration<T>) {
    static_assert(Words<T>::kShift == 0, "without a word for what is not known: make it optional");
    return get_known<T>(from).value_or(T{});
  } else if (field_.cpp_type() == Kind::CPPTYPE_UINT64) {
    return static_cast<T>(reflection_.GetUInt64(from, &field_));
  } else if (field_.cpp_type() == Kind::CPPTYPE_UINT32) {
    return static_cast<T>(reflection_.GetUInt32(from, &field_));
  } else {
    return static_cast<T>(reflection_.GetInt32(from, &field_));
  }
}

template <Enumeration T>
std::optional<T> FieldOf::get_known(const Message& from) const {
  const int number = reflection_.GetEnumValue(from, &field_);
  if (number < Words<T>::kShift || number > Words<T>::kLast) return std::nullopt;
  return static_cast<T>(number - Words<T>::kShift);
}

// Lists are of real numbers and of texts.
template <Scalar T>
void FieldOf::add(Message& to, const T& value) const {
  if constexpr (std::same_as<T, std::string>) {
    reflection_.AddString(&to, &field_, value);
  } else {
    static_assert(std::same_as<T, double>);
    reflection_.AddDouble(&to, &field_, value);
  }
}

template <Scalar T>
T FieldOf::get_at(const Message& from, int index) const {
  if constexpr (std::same_as<T, std::string>) {
    return reflection_.GetRepeatedString(from, &field_, index);
  } else {
    static_assert(std::same_as<T, double>);
    return reflection_.GetRepeatedDouble(from, &field_, index);
  }
}

}  // namespace gonio::wire
