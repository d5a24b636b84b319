#include "server/calls/upload.h"

#include <algorithm>
#include <utility>

#include "gonio/measured/table.h"

namespace gonio::server {
namespace {

constexpr std::size_t kSize = MeasuredTable::kFileBytes;
constexpr std::size_t kStep = std::size_t{1} << 20;  // of charges

std::string bytes(std::size_t count) { return std::to_string(count) + " bytes"; }

}  // namespace

Outcome Upload::take(const v1::PutMaterialRequest& part) {
  switch (part.part_case()) {
    case v1::PutMaterialRequest::kFile:
      if (begun_) return bad_value("file", "given twice", "the first message's alone");
      return begin(part.file());
    case v1::PutMaterialRequest::kChunk:
      if (!begun_) return bad_value("file", "not given", "what the first message holds");
      return add(part.chunk());
    case v1::PutMaterialRequest::PART_NOT_SET:
      break;
  }
  return bad_value("part", "not given", "file or chunk");
}

Outcome Upload::begin(const v1::MaterialFile& file) {
  if (file.sha256().size() != sum_.size()) {
    return bad_value("file.sha256", bytes(file.sha256().size()),
                     bytes(sum_.size()) + ", the SHA-256 of the file");
  }
  std::copy(file.sha256().begin(), file.sha256().end(), sum_.begin());
  if (auto good = materials_.check_put(file.name(), sum_); !good) return good;
  if (file.size() != kSize) {
    const auto code = file.size() > kSize ? ErrorCode::resource_exhausted : ErrorCode::data_loss;
    return bad_value("file.size", bytes(file.size()), bytes(kSize) + ", as every MERL file has",
                     code);
  }
  name_ = file.name();
  content_.reserve(kSize);
  begun_ = true;
  return Ok{};
}

Outcome Upload::add(const std::string& chunk) {
  if (chunk.size() > kSize - content_.size()) {
    return bad_value("chunk", bytes(content_.size() + chunk.size()) + " with those before",
                     bytes(kSize) + " in all, as was announced");
  }
  if (content_.size() + chunk.size() > charged_) {
    const std::size_t step = std::max(kStep, chunk.size());
    auto charge = memory_.take(step);
    if (!charge) {
      return Error{ErrorCode::resource_exhausted,
                   "the server's memory is full: requests and answers hold " +
                       bytes(memory_.held()) + " of " + std::to_string(memory_.limit()),
                   {},
                   {},
                   {}};
    }
    charges_.push_back(std::move(charge));
    charged_ += step;
  }
  hash_.add(chunk);
  content_ += chunk;
  return Ok{};
}

Outcome Upload::finish() {
  if (!begun_) return bad_value("file", "not given", "what the first message holds");
  if (content_.size() < kSize) {
    return bad_value("chunk", bytes(content_.size()) + " in all",
                     bytes(kSize) + ", as was announced", ErrorCode::data_loss);
  }
  const auto found = hash_.finish();
  if (found == sum_) return Ok{};
  return bad_value("file.sha256", wire::hexadecimal(sum_),
                   wire::hexadecimal(found) + ", that of the bytes that came",
                   ErrorCode::data_loss);
}

}  // namespace gonio::server
