#pragma once

#include "ui/editor/changes/cut_progress.h"
#include "ui/editor/changes/split_view.h"
#include "ui/editor/figures/figures.h"
#include "ui/editor/frame/file_browser.h"
#include "ui/editor/graph/graph_state.h"
#include "ui/editor/inspect/heat_probe.h"
#include "ui/editor/keys/command_palette.h"
#include "ui/editor/keys/settings_page.h"
#include "ui/editor/path/placed_lasers.h"
#include "ui/editor/play/play_state.h"
#include "ui/editor/single_step/stage_state.h"
#include "ui/editor/tools/hand.h"
#include "ui/editor/view/settings.h"
#include "ui/editor/view/view_state.h"
#include "ui/editor/work/open_work.h"
#include "ui/editor/work/opening.h"
#include "ui/editor/work/preparation.h"
#include "ui/editor/work/requests.h"
#include "ui/editor/work/unsaved_work.h"
#include "ui/window/message.h"

namespace kerf {

// All parts of the running editor. Only the files in this folder know all of them; everything else receives
// the parts that it needs.
struct EditorState {
  OpenWork work;
  Opening opening;
  Decisions decisions;
  Requests requests;

  ViewState view;
  Hand hand;
  SplitView split;
  StageState stages;
  Figures figures;
  CutProgress cutting;
  GraphState graph;
  PlacedLasers lasers;
  PlayState play;
  HeatProbe probe;
  Preparation preparation;

  Settings settings;
  Message message;
  FileBrowser browser;
  CommandPalette palette;
  SettingsPage settings_page;
  bool shortcuts_shown = false, messages_shown = false;
};

}  // namespace kerf
