// Plain structures as messages of the wire, each by one list that serves both directions.
//
//   template <>
//   struct Mapping<fit::Region> {
//     using Own = fit::Region;
//     using Message = v1::FitRegion;
//     static constexpr auto kFields =
//         fields<Own>(field(&Own::measured, Message::kMeasuredFieldNumber), ...);
//   };
//   v1::FitRegion sent = to_message(region);
//   Result<fit::Region> read = from_message<fit::Region>(sent);
//
// A list that leaves out a member of the structure does not compile. tests/wire/mapping_test.cpp
// holds that no field of a message is lost on the way there or back. Thread safety: functions
// without state.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "gonio/base/result.h"
#include "wire/mapping/member_count.h"
#include "wire/mapping/scalar.h"

namespace gonio::wire {

// Specialised for each structure, with `Message` and `kFields` as above; or, where the two are not
// alike, with `Message` and, for the directions that are needed, `void write(const T&, Message&)`
// and `Result<T> read(const Message&)`.
template <class T>
struct Mapping;

// A member and its field's number.
template <class T, class Member>
struct MappedField {
  Member T::*member;
  int number;
};
template <class T, class Member>
constexpr MappedField<T, Member> field(Member T::*member, int number) {
  return {member, number};
}

// Whether as many are listed as the structure has.
template <class T, std::size_t Listed>
concept EveryMember = Listed == member_count<T>();

template <class T, class... Members>
requires EveryMember<T, sizeof...(Members)>
constexpr auto fields(MappedField<T, Members>... all) { return std::make_tuple(all...); }

template <class T>
concept HasFields = requires {
  Mapping<T>::kFields;
};

template <class T>
void write(const T& from, google::protobuf::Message& to);
template <class T>
Outcome read(const google::protobuf::Message& from, T& to);
template <class T>
Outcome read_field(const google::protobuf::Message& message, const FieldOf& from, T& to);

template <class T>
inline constexpr bool kIsList = false;
template <class T>
inline constexpr bool kIsList<std::vector<T>> = true;
template <class T, std::size_t N>
inline constexpr bool kIsList<std::array<T, N>> = true;
template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

template <class T>
void write_field(const T& from, const FieldOf& to, google::protobuf::Message& message) {
  if constexpr (kIsOptional<T>) {
    if (from) write_field(*from, to, message);
  } else if constexpr (kIsList<T>) {
    for (const auto& element : from) {
      if constexpr (Scalar<std::decay_t<decltype(element)>>) {
        to.add(message, element);
      } else {
        write(element, to.add_message(message));
      }
    }
  } else if constexpr (Scalar<T>) {
    to.set(message, from);
  } else {
    write(from, to.mutable_message(message));
  }
}

template <class T>
Outcome read_list(const google::protobuf::Message& message, const FieldOf& from, T& to) {
  using Element = typename T::value_type;
  auto count = static_cast<std::size_t>(from.size(message));
  if constexpr (requires { to.resize(count); }) {
    to.resize(count);
  } else {
    count = std::min(count, to.size());  // an array's further elements keep their default
  }
  for (std::size_t i = 0; i < count; ++i) {
    const int index = static_cast<int>(i);
    if constexpr (Scalar<Element>) {
      to[i] = from.template get_at<Element>(message, index);
    } else if (auto good = read(from.message_at(message, index), to[i]); !good) {
      return good;
    }
  }
  return Ok{};
}

// Where there is a value. A structure that is read by a function of its own may have no default.
template <class T>
Outcome read_given(const google::protobuf::Message& message, const FieldOf& from,
                   std::optional<T>& to) {
  if constexpr (Enumeration<T>) {
    to = from.template get_known<T>(message);
    return Ok{};
  } else if constexpr (requires { typename Mapping<T>::Message; } && !HasFields<T>) {
    using Message = typename Mapping<T>::Message;
    auto converted = Mapping<T>::read(static_cast<const Message&>(from.message_in(message)));
    if (!converted) return converted.error();
    to = std::move(*converted);
    return Ok{};
  } else {
    return read_field(message, from, to.emplace());
  }
}

template <class T>
Outcome read_field(const google::protobuf::Message& message, const FieldOf& from, T& to) {
  if constexpr (kIsOptional<T>) {
    to.reset();
    return from.is_given(message) ? read_given(message, from, to) : Ok{};
  } else if constexpr (kIsList<T>) {
    return read_list(message, from, to);
  } else if constexpr (Scalar<T>) {
    to = from.template get<T>(message);
    return Ok{};
  } else {
    return read(from.message_in(message), to);
  }
}

template <class T>
void write(const T& from, google::protobuf::Message& to) {
  using Message = typename Mapping<T>::Message;
  if constexpr (HasFields<T>) {
    const auto write_one = [&](const auto& one) {
      write_field(from.*one.member, FieldOf(to, one.number), to);
    };
    std::apply([&](const auto&... all) { (write_one(all), ...); }, Mapping<T>::kFields);
  } else {
    Mapping<T>::write(from, static_cast<Message&>(to));
  }
}

template <class T>
Outcome read(const google::protobuf::Message& from, T& to) {
  using Message = typename Mapping<T>::Message;
  if constexpr (HasFields<T>) {
    Outcome good = Ok{};
    const auto read_one = [&](const auto& one) {
      if (good) good = read_field(from, FieldOf(from, one.number), to.*one.member);
    };
    std::apply([&](const auto&... all) { (read_one(all), ...); }, Mapping<T>::kFields);
    return good;
  } else {
    auto converted = Mapping<T>::read(static_cast<const Message&>(from));
    if (!converted) return converted.error();
    to = std::move(*converted);
    return Ok{};
  }
}

template <class T>
typename Mapping<T>::Message to_message(const T& from) {
  typename Mapping<T>::Message to;
  write(from, to);
  return to;
}

// Errors: those of a structure that is read by a function of its own. Numbers that are not there
// are 0; a word that is not known is the enum's 0, or none where the member is optional.
template <class T>
Result<T> from_message(const typename Mapping<T>::Message& from) {
  T to;
  if (auto good = read(from, to); !good) return good.error();
  return to;
}

}  // namespace gonio::wire
