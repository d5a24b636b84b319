#include "base/exit_code.h"

namespace gonio {
namespace {

const char* meaning_of(ExitCode code) {
  switch (code) {
    case exit_ok:
      return "done";
    case exit_failed:
      return "failed on the way";
    case exit_bad_input:
      return "wrong arguments, files or materials";
    case exit_unreachable:
      return "no answer from the server (not there, too busy, or past the deadline)";
    case exit_bad_verdict:
      return "done, but not within the limits, or nothing good enough";
  }
  return "";
}

}  // namespace

ExitCode exit_code_of(const Error& error) {
  switch (error.code) {
    case ErrorCode::invalid_argument:
    case ErrorCode::not_found:
    case ErrorCode::already_exists:
    case ErrorCode::data_loss:
      return exit_bad_input;
    case ErrorCode::resource_exhausted:
      // An error that names a bound is of a request that is too large; without one the server is
      // too busy.
      return error.allowed.empty() ? exit_unreachable : exit_bad_input;
    case ErrorCode::unavailable:
    case ErrorCode::deadline_exceeded:
      return exit_unreachable;
    case ErrorCode::cancelled:
    case ErrorCode::internal:
      break;
  }
  return exit_failed;
}

std::string exit_status_text(std::span<const ExitCode> codes) {
  std::string text = "Exit status:\n";
  for (const ExitCode code : codes)
    text += "  " + std::to_string(static_cast<int>(code)) + "  " + meaning_of(code) + "\n";
  text.pop_back();
  return text;
}

}  // namespace gonio
