// The registry: every analytic model, one line each. The order is that of ListModels and of the
// kernel tables.
#pragma once

#include "models/ashikhmin_shirley.h"
#include "models/blinn_phong.h"
#include "models/cook_torrance.h"
#include "models/ggx.h"
#include "models/lambertian.h"
#include "models/oren_nayar.h"
#include "models/phong.h"
#include "models/phong_mix.h"
#include "models/ward.h"
#include "numeric/type_list.h"

namespace gonio {

using AllModels = TypeList<  //
    Lambertian,              //
    AshikhminShirley,        //
    CookTorrance,            //
    Ggx,                     //
    Phong,                   //
    BlinnPhong,              //
    PhongMix,                //
    OrenNayar,               //
    Ward>;

// The kinds of all models, in that order: of each the words' combinations, the last word fastest.
template <class... Models>
Concatenated<typename Models::Kinds...> all_kinds(TypeList<Models...>);
using AllKinds = decltype(all_kinds(AllModels{}));

}  // namespace gonio
