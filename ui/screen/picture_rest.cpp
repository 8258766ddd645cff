#include "ui/screen/picture_rest.h"

namespace kerf {

void PictureRest::follow(PictureChange change, double now) {
  now_ = now;
  if (change != PictureChange::kNothing) changed_ = now;
  if (change == PictureChange::kAll) moved_ = now;
}

}  // namespace kerf
