// The registry: every analytic model, one line each. The order is that of ListModels and of the
// kernel tables.
#pragma once

#include "models/ashikhmin_shirley.h"
#include "models/cook_torrance.h"
#include "models/ggx.h"
#include "models/lambertian.h"
#include "numeric/type_list.h"

namespace gonio {

using AllModels = TypeList<  //
    Lambertian,              //
    AshikhminShirley,        //
    CookTorrance,            //
    Ggx>;

}  // namespace gonio
