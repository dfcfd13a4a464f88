#pragma once
#include <string>
#include <vector>

#include "render/picture.h"

namespace morphgrid {

/// A part of a sheet: a picture's scene with its caption and legend.
struct Panel {
  Image scene;          ///< Its size is sceneSize(panelPicture()).
  std::string caption;  ///< See PictureOptions.
  std::optional<Legend> legend{};
  std::optional<ScaleBar> scaleBar{};
};

struct SheetOptions {
  std::string title;      ///< One line of UTF-8.
  int columns = 3;        ///< >= 1; of fewer panels, as many as there are.
  int panelWidth = 640;   ///< In pixels, footer included, >= kSmallestPicture
  int panelHeight = 480;  ///< As above.
};

/// In pixels.
struct SheetSize {
  int width;
  int height;
};

constexpr int kMostPanels = 26;

/// The picture that a panel is, without caption and legend: larger letters than a picture by
/// itself has, since sheets are looked at as a whole.
PictureOptions panelPicture(const SheetOptions& options);

/// Throws InputError when the sheet would have more bytes than PNG files here can.
SheetSize sheetSize(const SheetOptions& options, int panelCount);

/// The panels under the title, on white, row by row, their captions numbered (a), (b), ... panels:
/// 1 to kMostPanels. Throws InputError as sheetSize(), and when there is no font.
Image composeSheet(const std::vector<Panel>& panels, const SheetOptions& options);

/// Lines of text as the scene of a panel, in letters of one width, as large as the image holds all
/// of them but not larger than a panel's caption. Throws InputError when there is no font.
Image drawText(const std::string& text, const SheetOptions& options);

}  // namespace morphgrid
