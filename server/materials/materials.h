// The materials that a server holds by name, and the way from a request's material to one that can
// be evaluated.
//
// Thread safety: after load(), allow_local_files() and allow_puts(), any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <string>
#include <string_view>
#include <vector>

#include "gonio/base/result.h"
#include "gonio/engine/material.h"
#include "gonio/v1/material.pb.h"
#include "server/materials/build_material.h"
#include "server/materials/local_files.h"
#include "server/materials/material_cache.h"
#include "wire/sha256.h"

namespace gonio::server {

// Where a material that a client put is kept.
enum class PutPlace : std::uint8_t { folder, memory };

// A file of the materials folder that is not served.
struct Skipped {
  std::string name;    // of the material that it would be
  std::string reason;  // names the file, not the folder: it goes to clients
};

struct PutResult {
  PutPlace place = PutPlace::memory;
  std::size_t invalid_cells = 0;
  bool existed = false;  // the same bytes were put under this name before
};

class Materials {
 public:
  Materials() = default;

  // Every *.json (see material.proto; also {"model": "measured", "parameters": {"file": "x.binary",
  // "interpolation": "nearest"}}, the file within `folder`) and every MERL *.binary of `folder`,
  // each under its name without the extension. A file that cannot be used is skipped, as are two of
  // one name: of neither is it known that it is the one meant. Errors: a folder that cannot be
  // read.
  static Result<Materials> load(const std::filesystem::path& folder);

  // Lets resolve() read files of this machine.
  void allow_local_files();

  // Lets put() store materials, as long as their tables hold at most `quota_bytes` together.
  // Removes what servers that were killed have left of theirs in the folder; says how many files.
  std::size_t allow_puts(std::size_t quota_bytes);

  [[nodiscard]] std::vector<std::string> names() const;  // sorted
  [[nodiscard]] const std::vector<Skipped>& skipped() const { return skipped_; }
  [[nodiscard]] bool holds(std::string_view name) const;

  // Whether put() of this name and sum may succeed. Errors: invalid_argument for a name of other
  // than 1 to 100 letters, digits, '-' and '_'; already_exists for one that is taken (unless by a
  // put of the same bytes), if only by a file that is not served; resource_exhausted where the
  // quota leaves no room.
  [[nodiscard]] Outcome check_put(const std::string& name, const wire::Sha256Sum& sum) const;
  // Stores a MERL file's content, of which `sum` is the SHA-256, under `name`: in the folder as a
  // new file that appears as a whole, or in memory. Takes a while. Errors: those of check_put() and
  // of the file ("chunk"), and what keeps the file from being written.
  Result<PutResult> put(const std::string& name, std::string content, const wire::Sha256Sum& sum);

  // The material that a request asks for, by the serialised gonio.v1.Material in it (none if it has
  // none). Errors name the field as "material....".
  [[nodiscard]] Result<PreparedMaterial> resolve(const std::optional<std::string>& bytes) const;

 private:
  [[nodiscard]] Result<PreparedMaterial> build(const v1::Material& material) const;
  // The substance (preset_material.h) that is asked for by a name under which nothing is stored.
  [[nodiscard]] std::optional<v1::Material> substance_of(const v1::Material& material) const;
  // The same of a file of this machine.
  [[nodiscard]] Result<PreparedMaterial> build_local(const v1::Material& material,
                                                     const std::string& bytes) const;
  Outcome add(const std::filesystem::path& file);
  void skip(const std::filesystem::path& file, std::string reason);
  [[nodiscard]] const Skipped* find_skipped(std::string_view name) const;
  [[nodiscard]] Error not_stored(const std::string& name) const;

  struct Stored {
    PreparedMaterial material;
    std::optional<wire::Sha256Sum> sum;  // of what was put
    PutResult put;
  };
  // Apart, so that a Materials can be moved. Puts follow each other; only their last step, which
  // takes no time, holds up requests.
  struct Locks {
    std::shared_mutex stored;
    std::mutex putting;
  };

  [[nodiscard]] const Stored* find(std::string_view name) const;  // locks_->stored is held
  [[nodiscard]] std::optional<PreparedMaterial> find_copy(std::string_view name) const;

  std::map<std::string, Stored, std::less<>> stored_;
  std::vector<Skipped> skipped_;
  std::size_t put_bytes_ = 0, put_quota_ = 0;
  std::filesystem::path folder_;  // empty: none
  std::unique_ptr<Locks> locks_ = std::make_unique<Locks>();
  FindFile find_file_;
  // Stored materials never change, so that their names can be kept as well; files of this machine
  // may change.
  std::unique_ptr<MaterialCache> cache_ = std::make_unique<MaterialCache>();
  std::unique_ptr<LocalFiles> local_files_ = std::make_unique<LocalFiles>();
};

}  // namespace gonio::server
