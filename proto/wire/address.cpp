#include "wire/address.h"

#include <sys/un.h>

#include <algorithm>
#include <charconv>
#include <cstdio>

namespace gonio::wire {
namespace {

constexpr std::string_view kUnix = "unix:", kAbstract = "unix-abstract:";
constexpr std::size_t kLongestPath = sizeof(sockaddr_un::sun_path) - 1;

std::string quoted(std::string_view text) { return '"' + std::string(text) + '"'; }

bool is_port(std::string_view text, unsigned least) {
  unsigned value = 0;
  const char* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && at == end && value >= least && value <= 65535;
}

bool has_gap_or_control(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte <= 0x20 || byte == 0x7F;
  });
}

bool is_plain_host(std::string_view text) {
  return !text.empty() && text.find_first_of(":/[]") == std::string_view::npos &&
         !has_gap_or_control(text);
}

bool is_bracketed(std::string_view text) {
  if (text.size() < 3 || text.front() != '[' || text.back() != ']') return false;
  const std::string_view inside = text.substr(1, text.size() - 2);
  return inside.find_first_of("/[]") == std::string_view::npos && !has_gap_or_control(inside);
}

std::string allowed(unsigned least_port) {
  return R"("host:port", "[::1]:port", "unix:PATH" or "unix:///PATH", the port from )" +
         std::to_string(least_port) + " to 65535";
}

// Two slashes at the beginning are refused: a URI has a host there.
Result<Address> parse_unix(std::string_view text, std::string_view field, unsigned least_port) {
  std::string_view path = text.substr(kUnix.size());
  const std::size_t slashes = std::min(path.find_first_not_of('/'), path.size());
  if (path.empty() || slashes == 2) return bad_value(field, quoted(text), allowed(least_port));
  if (slashes > 1) path.remove_prefix(slashes - 1);
  if (path.find('\0') != std::string_view::npos)
    return bad_value(field, quoted(text), "a socket path without NUL bytes");
  if (path.size() > kLongestPath) {
    return bad_value(field, quoted(text),
                     "a socket path of at most " + std::to_string(kLongestPath) +
                         " bytes (this one has " + std::to_string(path.size()) + ")");
  }
  return Address{std::string(kUnix).append(path), std::string(path), {}, {}};
}

// Escapes all but the characters that every part of a URI takes literally.
std::string escaped(std::string_view text) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/:";
  std::string result;
  for (const char c : text) {
    if (kPlain.find(c) != std::string_view::npos) {
      result += c;
      continue;
    }
    char code[4];
    (void)std::snprintf(code, sizeof code, "%%%02X",
                        static_cast<unsigned>(static_cast<unsigned char>(c)));
    result += code;
  }
  return result;
}

}  // namespace

Result<Address> parse_address(std::string_view text, std::string_view field, unsigned least_port) {
  if (text.starts_with(kUnix)) return parse_unix(text, field, least_port);
  const std::size_t colon = text.rfind(':');
  const std::string_view host = text.substr(0, colon == std::string_view::npos ? 0 : colon);
  const bool bracketed = is_bracketed(host);
  if (text.starts_with(kAbstract) || (!bracketed && !is_plain_host(host)) ||
      !is_port(text.substr(colon + 1), least_port)) {
    return bad_value(field, quoted(text), allowed(least_port));
  }
  const std::string_view name = bracketed ? host.substr(1, host.size() - 2) : host;
  return Address{std::string(text), {}, std::string(name), std::string(text.substr(colon + 1))};
}

// The prefix marks the host as one: gRPC would read "dns:80" as port 80 without a host.
std::string grpc_target(const Address& address) {
  if (address.is_unix()) return std::string(kUnix) + escaped(address.path);
  return "dns:///" + escaped(address.text);
}

}  // namespace gonio::wire
