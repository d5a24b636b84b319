// Errors as values. Every fallible function of the core returns Result<T>; nothing throws for bad
// input.
//
// An Error names the field that is wrong, the value it had and what would have been allowed, so
// that a caller (or the wire) can pass all three on in a machine-readable form. `message` says the
// same in one sentence. Thread safety: plain values.
#pragma once

#include <cassert>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace gonio {

enum class ErrorCode {
  invalid_argument,    // the request is wrong whatever the state of the service
  not_found,           // a model, material or file that does not exist
  already_exists,      // a name that is taken
  data_loss,           // a file that is truncated or corrupt
  resource_exhausted,  // too large, or the queue is full: smaller or later may work
  cancelled,
  deadline_exceeded,
  unavailable,  // the service is going down
  internal,
};

struct Error {
  ErrorCode code = ErrorCode::internal;
  std::string message;  // one sentence, complete by itself
  std::string field;    // e.g. "specular[0].parameters.alpha_x"; empty if there is none
  std::string value;    // what was given
  std::string allowed;  // what would have been accepted
};

// Builds the usual sentence: "<field> is <value>; allowed: <allowed>". Field and value may come
// from outside: they are quoted as shown() quotes them (gonio/base/shown.h).
Error bad_value(std::string_view field, std::string_view value, std::string_view allowed,
                ErrorCode code = ErrorCode::invalid_argument);

template <class T>
class [[nodiscard]] Result {
 public:
  // Implicit, so that `return value;` and `return error;` read as they should.
  // NOLINTBEGIN(google-explicit-constructor)
  Result(T value) : state_(std::move(value)) {}
  Result(Error error) : state_(std::move(error)) {}
  // NOLINTEND(google-explicit-constructor)

  [[nodiscard]] bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  T& value() & { return assert(ok()), std::get<0>(state_); }
  const T& value() const& { return assert(ok()), std::get<0>(state_); }
  T&& value() && { return assert(ok()), std::get<0>(std::move(state_)); }
  const Error& error() const& { return assert(!ok()), std::get<1>(state_); }
  Error&& error() && { return assert(!ok()), std::get<1>(std::move(state_)); }

  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }

 private:
  std::variant<T, Error> state_;
};

struct Ok {};
using Outcome = Result<Ok>;  // success, or why not

}  // namespace gonio
