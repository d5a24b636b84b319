// Every model and every measured format, a line each: the one place where a new one is added.
//
// GONIO_MODEL(name, Type) stands for src/models/name.h and its struct Type. GONIO_FORMAT(Type)
// stands for a folder of src/measured that defines kTypeModel. The order is that of ListModels. The
// build reads the file, too: it compiles the kernels of each model as a file of their own.

GONIO_MODEL(lambertian, Lambertian)
GONIO_MODEL(ashikhmin_shirley, AshikhminShirley)
GONIO_MODEL(cook_torrance, CookTorrance)
GONIO_MODEL(ggx, Ggx)
GONIO_MODEL(phong, Phong)
GONIO_MODEL(blinn_phong, BlinnPhong)
GONIO_MODEL(phong_mix, PhongMix)
GONIO_MODEL(oren_nayar, OrenNayar)
GONIO_MODEL(ward, Ward)
GONIO_FORMAT(Merl)
