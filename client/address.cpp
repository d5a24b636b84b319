#include "client/address.h"

#include <charconv>
#include <string>

namespace gonio::client {
namespace {

constexpr std::string_view kUnix = "unix:";

bool is_port(std::string_view text) {
  unsigned value = 0;
  const char* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && at == end && value >= 1 && value <= 65535;
}

bool is_host(std::string_view text) {
  const bool bracketed = text.size() > 2 && text.front() == '[' && text.back() == ']';
  return bracketed || (!text.empty() && text.find_first_of(":/[] ") == std::string_view::npos);
}

}  // namespace

Outcome check_address(std::string_view address) {
  if (address.starts_with(kUnix) && address.size() > kUnix.size()) return Ok{};
  const std::size_t colon = address.rfind(':');
  if (colon != std::string_view::npos && is_host(address.substr(0, colon)) &&
      is_port(address.substr(colon + 1))) {
    return Ok{};
  }
  return bad_value("address", '"' + std::string(address) + '"',
                   R"("host:port", "[::1]:port" or "unix:/path", the port from 1 to 65535)");
}

}  // namespace gonio::client
