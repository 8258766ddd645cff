#include "ui/editor/features.h"

#include "ui/editor/files/files_feature.h"
#include "ui/editor/graph/graph_feature.h"
#include "ui/editor/history/history_feature.h"
#include "ui/editor/inspect/inspect_feature.h"
#include "ui/editor/laser/laser_feature.h"
#include "ui/editor/light/light_feature.h"
#include "ui/editor/material/material_feature.h"
#include "ui/editor/moving/moving_feature.h"
#include "ui/editor/path/emitter_feature.h"
#include "ui/editor/path/path_feature.h"
#include "ui/editor/pieces/pieces_feature.h"
#include "ui/editor/prepare/prepare_feature.h"
#include "ui/editor/recent/recent_feature.h"
#include "ui/editor/ruler/ruler_feature.h"
#include "ui/editor/scalar_map/scalar_map_feature.h"
#include "ui/editor/section/section_feature.h"
#include "ui/editor/shell/dialogs.h"
#include "ui/editor/single_step/single_step_feature.h"
#include "ui/editor/split/split_feature.h"
#include "ui/editor/statistics/statistics_feature.h"
#include "ui/editor/time/time_feature.h"
#include "ui/editor/tree/tree_feature.h"
#include "ui/editor/view/view_feature.h"
#include "ui/editor/welcome/welcome_feature.h"

namespace kerf {

Features make_features(Workspace& on, const Catalogue& catalogue) {
  Features features;
  features.push_back(files_feature(on));
  features.push_back(recent_feature(on));
  features.push_back(dialogs(on, catalogue));
  features.push_back(welcome_feature(on));
  features.push_back(view_feature(on));
  features.push_back(light_feature(on));
  features.push_back(section_feature(on));
  features.push_back(emitter_feature(on));
  features.push_back(path_feature(on));
  features.push_back(moving_feature(on));
  features.push_back(time_feature(on));
  features.push_back(inspect_feature(on));
  features.push_back(ruler_feature(on));
  features.push_back(pieces_feature(on));
  features.push_back(history_feature(on));
  features.push_back(material_feature(on));
  features.push_back(prepare_feature(on));
  features.push_back(tree_feature(on));
  features.push_back(scalar_map_feature(on));
  features.push_back(graph_feature(on));
  features.push_back(single_step_feature(on));
  features.push_back(statistics_feature(on));
  features.push_back(split_feature(on));
  features.push_back(laser_feature(on));
  return features;
}

}  // namespace kerf
