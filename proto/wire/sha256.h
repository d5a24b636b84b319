// SHA-256 (FIPS 180-4, by OpenSSL), with which the receiver of an upload checks its bytes. Thread
// safety: used by one thread.
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
  // The digest of all that was added. Called once.
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
