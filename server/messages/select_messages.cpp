#include "server/messages/select_messages.h"

#include "server/messages/material_message.h"
#include "wire/mapping/selection.h"

namespace gonio::server {

v1::SelectResult to_wire(const select::Selection& selection) { return wire::to_message(selection); }

}  // namespace gonio::server
