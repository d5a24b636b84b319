// Numbers that no substance has, which say that another word of the model may be meant.
#pragma once

#include <optional>
#include <string>

#include "fit/form.h"
#include "gonio/fit/certificate.h"

namespace gonio::fit {

// For half of a number that substances have by name (eta of eta + i k), fitted without its other
// half, where it is beyond all of theirs: the number, their largest, and the word that has both.
std::optional<std::string> substance_hint(const Form& form, const Certificate& report);

}  // namespace gonio::fit
