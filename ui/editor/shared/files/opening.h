#pragma once

#include <vector>

#include "core/document/journal/autosave.h"
#include "ui/editor/shared/files/file_loader.h"
#include "ui/window/message.h"

namespace kerf {

// Files that are being read, and work that waits to be opened.
struct Opening {
  FileLoader loader;
  std::vector<LeftWork> left_work;  // of editors that died, about which the user was not asked yet
};

// Gives up what is being read and says so; what is open stays as it is. Precondition: the loader is busy.
void cancel_opening(Opening& opening, Message& message);

}  // namespace kerf
