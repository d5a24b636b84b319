// SHA-256, by which the two sides of an upload agree on what was sent (FIPS 180-4; OpenSSL's).
// Thread safety: used by one thread.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct evp_md_ctx_st;

namespace gonio::wire {

using Sha256Sum = std::array<std::uint8_t, 32>;

class Sha256 {
 public:
  Sha256();
  void add(std::string_view bytes);
  // Of all that was added; once.
  [[nodiscard]] Sha256Sum finish();

 private:
  struct Free {
    void operator()(evp_md_ctx_st* context) const;
  };
  std::unique_ptr<evp_md_ctx_st, Free> context_;
};

Sha256Sum sha256(std::string_view bytes);

// 64 hexadecimal digits, as sha256sum prints them.
std::string hexadecimal(const Sha256Sum& sum);

}  // namespace gonio::wire
