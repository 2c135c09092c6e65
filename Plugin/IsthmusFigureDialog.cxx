#include "IsthmusFigureDialog.h"

#include "RunPython.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include <cmath>

IsthmusFigureDialog::IsthmusFigureDialog(QWidget* parent)
  : QDialog(parent)
  , Width(new QDoubleSpinBox(this))
  , Resolution(new QSpinBox(this))
  , Pixels(new QLabel(this))
  , Background(new QComboBox(this))
  , ScaleBar(new QCheckBox(tr("Scale bar"), this))
  , Outlines(new QCheckBox(tr("Soft shadows and outlines"), this))
{
  this->setObjectName("IsthmusFigure");
  this->setWindowTitle(tr("Save Figure"));
  this->Width->setObjectName("Width");
  this->Width->setRange(10.0, 1000.0);
  this->Width->setDecimals(1);
  this->Width->setValue(85.0); // a column of a journal
  this->Width->setSuffix(" mm");
  this->Resolution->setObjectName("Resolution");
  this->Resolution->setRange(30, 2400);
  this->Resolution->setValue(300);
  this->Resolution->setSuffix(tr(" dots per inch"));
  this->Background->setObjectName("Background");
  this->Background->addItem(tr("As in the view"), "None");
  this->Background->addItem(tr("White"), "[1.0, 1.0, 1.0]");
  this->Background->addItem(tr("Black"), "[0.0, 0.0, 0.0]");
  this->ScaleBar->setObjectName("ScaleBar");
  this->ScaleBar->setChecked(true);
  this->Outlines->setObjectName("Outlines");
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this);
  auto* form = new QFormLayout(this);
  form->addRow(tr("Width"), this->Width);
  form->addRow(tr("Resolution"), this->Resolution);
  form->addRow(tr("Size"), this->Pixels);
  form->addRow(tr("Background"), this->Background);
  form->addRow(this->ScaleBar);
  form->addRow(this->Outlines);
  form->addRow(buttons);
  QObject::connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  QObject::connect(this->Width, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
    &IsthmusFigureDialog::ShowPixels);
  QObject::connect(this->Resolution, QOverload<int>::of(&QSpinBox::valueChanged), this,
    &IsthmusFigureDialog::ShowPixels);
  this->ShowPixels();
}

void IsthmusFigureDialog::ShowPixels()
{
  constexpr double millimetresPerInch = 25.4;
  const double across =
    std::round(this->Width->value() / millimetresPerInch * this->Resolution->value());
  this->Pixels->setText(
    tr("%1 pixels wide, as high as the view is in proportion").arg(across, 0, 'f', 0));
}

void IsthmusFigureDialog::accept()
{
  // The client writes the file, so the path is on this machine.
  QString path = QFileDialog::getSaveFileName(this, tr("Save Figure"), "figure.png",
    tr("Picture and vectors (*.png)"), nullptr, QFileDialog::DontUseNativeDialog);
  if (path.isEmpty())
  {
    return;
  }
  path.replace('\\', "\\\\").replace('"', "\\\"");
  isthmus::RunPipelines(QString("save_figure(\"%1\", %2, %3, %4, %5, %6)")
                          .arg(path)
                          .arg(this->Width->value())
                          .arg(this->Resolution->value())
                          .arg(this->Background->currentData().toString())
                          .arg(this->ScaleBar->isChecked() ? "True" : "False")
                          .arg(this->Outlines->isChecked() ? "True" : "False"));
  this->QDialog::accept();
}
