#include "client/messages/select_convert.h"

#include <utility>

#include "client/messages/message_json.h"
#include "wire/mapping/selection.h"

namespace gonio::wire {

template <>
struct Mapping<client::Material> {
  using Message = v1::Material;
  static Result<client::Material> read(const Message& from) { return client::material_of(from); }
};

}  // namespace gonio::wire

namespace gonio::client {

SelectProgress progress_of(const gonio::v1::SelectProgress& progress) {
  return wire::from_message<SelectProgress>(progress).value();  // of numbers and texts alone
}

Result<Selection> selection_of(const gonio::v1::SelectResult& result) {
  auto json = json_of(result);
  if (!json) return json.error();
  Selection selection;
  selection.json = std::move(*json);
  if (auto read = wire::read<gonio::select::SelectionOf<Material>>(result, selection); !read)
    return read.error();
  if (selection.choice && selection.choice->entry >= selection.entries.size())
    return Error{ErrorCode::internal, "the server chose what it did not try", {}, {}, {}};
  return selection;
}

}  // namespace gonio::client
