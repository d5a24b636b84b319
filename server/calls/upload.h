// What has come of a PutMaterial call so far: the announced file, checked part by part. Thread
// safety: used by one thread at a time.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "gonio/base/result.h"
#include "gonio/v1/put.pb.h"
#include "server/materials/materials.h"
#include "server/work/memory_budget.h"
#include "wire/sha256.h"

namespace gonio::server {

class Upload {
 public:
  Upload(const Materials& materials, MemoryBudget& memory)
      : materials_(materials), memory_(memory) {}

  // The next part. Errors name it ("file.name", "chunk"); resource_exhausted without an allowed
  // value where the memory is full for the moment.
  Outcome take(const v1::PutMaterialRequest& part);
  // After the last part. Errors: bytes that are missing (data_loss), another sum than was
  // announced.
  Outcome finish();

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const wire::Sha256Sum& sum() const { return sum_; }
  [[nodiscard]] std::size_t size() const { return content_.size(); }
  std::string take_content() { return std::move(content_); }

 private:
  Outcome begin(const v1::MaterialFile& file);
  Outcome add(const std::string& chunk);

  const Materials& materials_;
  MemoryBudget& memory_;
  bool begun_ = false;
  std::string name_;
  wire::Sha256Sum sum_{};  // announced
  wire::Sha256 hash_;
  std::string content_;
  std::vector<MemoryBudget::Charge> charges_;  // for what has come, not for what was announced
  std::size_t charged_ = 0;
};

}  // namespace gonio::server
