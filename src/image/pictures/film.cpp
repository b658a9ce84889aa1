#include "image/picture_format.h"

namespace flatray::film_format {

extern const PictureFormat entry = {.name = "film",
                                    .summary = "light of lamps, to which more rays can be added",
                                    .kind = "a film",
                                    .beginning = kFilmSignature,
                                    .of_film = &encode_film};

}  // namespace flatray::film_format
