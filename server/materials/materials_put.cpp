// How a material that a client put comes to be stored.
#include <algorithm>
#include <optional>
#include <utility>

#include "gonio/measured/table.h"
#include "server/materials/material_folder.h"
#include "server/materials/materials.h"

namespace gonio::server {
namespace {

constexpr std::size_t kTableBytes =
    sizeof(float) * MeasuredTable::kChannels * MeasuredTable::kCells;
constexpr std::size_t kLongestName = 100;

// No dot and no slash: such a name is neither a path nor taken for a file by anybody.
bool is_name(const std::string& name) {
  constexpr std::string_view kCharacters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
  return !name.empty() && name.size() <= kLongestName &&
         name.find_first_not_of(kCharacters) == std::string::npos;
}

Error taken(const std::string& name) {
  return bad_value("file.name", "\"" + name + "\", which is taken",
                   "a name that no stored material has", ErrorCode::already_exists);
}

// Errors of a file name the file; that of a call has no name but its field's.
Error of_chunks(Error error) {
  error.field = "chunk";
  return error;
}

}  // namespace

std::size_t Materials::allow_puts(std::size_t quota_bytes) {
  put_quota_ = quota_bytes;
  return quota_bytes > 0 && !folder_.empty() ? remove_leftovers(folder_) : 0;
}

Outcome Materials::check_put(const std::string& name, const wire::Sha256Sum& sum) const {
  if (!is_name(name)) {
    return bad_value("file.name", "\"" + name + "\"",
                     "1 to " + std::to_string(kLongestName) + " letters, digits, '-' and '_'");
  }
  if (find_skipped(name) != nullptr) {
    return bad_value("file.name",
                     "\"" + name + "\", for which the server has a file that it cannot use",
                     "a name that no stored material has", ErrorCode::already_exists);
  }
  const std::shared_lock lock(locks_->stored);
  if (const Stored* stored = find(name)) return stored->sum == sum ? Outcome(Ok{}) : taken(name);
  if (kTableBytes <= put_quota_ && put_bytes_ <= put_quota_ - kTableBytes) return Ok{};
  return bad_value("file", "a table of " + std::to_string(kTableBytes) + " bytes",
                   "what is left of " + std::to_string(put_quota_) +
                       " bytes for put materials: " + std::to_string(put_quota_ - put_bytes_),
                   ErrorCode::resource_exhausted);
}

Result<PutResult> Materials::put(const std::string& name, std::string content,
                                 const wire::Sha256Sum& sum) {
  const std::lock_guard in_turn(locks_->putting);
  if (auto good = check_put(name, sum); !good) return good.error();
  {
    const std::shared_lock lock(locks_->stored);
    if (const Stored* stored = find(name)) {
      PutResult before = stored->put;
      before.existed = true;
      return before;
    }
  }
  std::optional<NewFile> file;
  if (!folder_.empty() && can_be_written(folder_)) {
    auto created = NewFile::create(folder_, content);
    if (!created) return created.error();
    file = std::move(*created);
  }
  auto table = MeasuredTable::parse_merl(std::move(content), "the file");
  if (!table) return of_chunks(table.error());
  if (file) {
    if (auto placed = file->place(name); !placed) return placed.error();
  }
  const PutResult result{file ? PutPlace::folder : PutPlace::memory, (*table)->invalid_cells(),
                         false};
  Stored stored{Material::from_table(std::move(*table), Interpolation::linear), sum, result};
  const std::unique_lock lock(locks_->stored);
  put_bytes_ += kTableBytes;
  stored_.emplace(name, std::move(stored));
  return result;
}

}  // namespace gonio::server
