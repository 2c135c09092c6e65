/**
 * @file IsthmusFigureDialog.h
 * @brief Isthmus > Save figure: size, resolution and background of a figure of the active view.
 */
#ifndef IsthmusFigureDialog_h
#define IsthmusFigureDialog_h

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;

class IsthmusFigureDialog : public QDialog
{
  Q_OBJECT

public:
  explicit IsthmusFigureDialog(QWidget* parent);

  /// Opens a file dialog, then writes the figure (pipelines.save_figure()).
  void accept() override;

private:
  void ShowPixels();

  QDoubleSpinBox* Width; ///< mm
  QSpinBox* Resolution;  ///< dots per inch
  QLabel* Pixels;
  QComboBox* Background;
  QCheckBox* ScaleBar;
  QCheckBox* Outlines;
};

#endif
