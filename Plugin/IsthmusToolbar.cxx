#include "IsthmusToolbar.h"

#include "IsthmusBrowser.h"
#include "IsthmusFigureDialog.h"
#include "IsthmusProgress.h"
#include "RunPython.h"

#include <pqActiveObjects.h>
#include <pqApplicationCore.h>
#include <pqCoreUtilities.h>
#include <pqFiltersMenuReaction.h>
#include <pqOutputPort.h>
#include <pqPipelineSource.h>
#include <pqPropertiesPanel.h>
#include <pqServer.h>
#include <pqServerManagerModel.h>
#include <pqUndoStack.h>

#include <vtkSMDocumentation.h>
#include <vtkSMInputProperty.h>
#include <vtkSMProxy.h>
#include <vtkSMSessionProxyManager.h>

#include <QApplication>
#include <QIcon>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QStringList>
#include <QTimer>
#include <QToolBar>

namespace
{

/// Like pressing Apply: a pipeline starts from the values shown in the panel.
void ApplyPendingChanges()
{
  auto* panel = pqCoreUtilities::mainWidget()->findChild<pqPropertiesPanel*>();
  if (panel && panel->canApply())
  {
    panel->apply();
  }
}

/// Runs a pipeline on the values shown in the panel. Earlier steps can no longer be undone, since
/// it depends on them.
void Run(const QString& call, const QString& title)
{
  IsthmusProgress& progress = IsthmusProgress::Instance();
  if (progress.IsRunning())
  {
    return;
  }
  ApplyPendingChanges();
  QApplication::setOverrideCursor(Qt::BusyCursor);
  progress.Begin(title);
  isthmus::RunPipelines(call);
  progress.End();
  CLEAR_UNDO_STACK();
  QApplication::restoreOverrideCursor();
}

/// ParaView adds the toolbar to a row that is full, so that half of it would be hidden behind an
/// arrow; the last row has room, also for its name.
void MoveToLastRow(QMainWindow* window)
{
  auto* bar = window->findChild<QToolBar*>("Isthmus");
  if (!bar)
  {
    return;
  }
  window->addToolBar(Qt::TopToolBarArea, bar);
  if (!bar->findChild<QLabel*>("IsthmusName") && !bar->actions().isEmpty())
  {
    auto* name = new QLabel(" Isthmus ", bar);
    name->setObjectName("IsthmusName");
    bar->insertWidget(bar->actions().first(), name);
  }
  bar->show();
}

/// A submenu: buttons of the toolbar, then filters, which the menu Filters > Isthmus lists
/// alphabetically.
struct Task
{
  const char* Title;
  QStringList Buttons, Filters;
};

const QList<Task>& Tasks()
{
  static const QList<Task> tasks{
    { "Density maps", { "map_to_surface", "map_with_model" },
      { "MapSurface", "DenoiseMap", "DenoiseFromHalfMaps", "HighOrderDiffusion",
        "DiffusionHighPass", "PDETransform", "DualContouring", "DelaunayIsosurface",
        "SurfaceToGrid" } },
    { "Curvature", { "map_to_curvature" },
      { "CurvatureOnSurface", "HessianCurvature", "SurfaceCurvature", "ScalarRegions" } },
    { "Loops, handles and persistence",
      { "map_to_loops", "surface_to_loops", "trajectory_to_loops", "persistence_diagram",
        "selected_loops", "all_loops" },
      { "ChokingLoops", "MapHandles", "HandleFilling", "LoopShortening", "ScalarPersistence",
        "FullereneStability" } },
    { "Molecules and their surfaces", { "protein_to_surface" },
      { "AtomSelection", "MoleculeCartoon", "MolecularDensity", "MolecularFlowSurface",
        "NonpolarSolvation" } },
    { "Pockets, pores and sites", { "protein_to_pockets", "protein_to_pores", "protein_to_sites" },
      { "MolecularPockets", "PoreProfile", "BindingSites", "BindingSitesInPockets",
        "FeatureTracks" } },
    { "Electrostatics and ions", { "protein_to_sites" },
      { "ForceFieldCharges", "ForceFieldChargesAndLigands", "PoissonBoltzmann",
        "PoissonBoltzmannOnSurface", "PolarizedCurvature", "PolarizedCurvatureOfArray",
        "SolvationSurface", "IonTransport", "IonTransportOnSurface",
        "IonTransportMovingSurface" } },
    { "Surfaces and meshes", {},
      { "SurfaceMeasures", "SurfaceRemesh", "OffsetSurface", "TetrahedralMesher",
        "IsosurfaceStuffing", "TetCutaway", "MeshQualityReport", "CellIncidence" } },
  };
  return tasks;
}

vtkSMProxy* FindPrototype(const QString& filter)
{
  pqServer* server = pqActiveObjects::instance().activeServer();
  return server ? server->proxyManager()->GetPrototypeProxy("filters", filter.toUtf8().constData())
                : nullptr;
}

/// Whether the filter takes the selected source.
bool Fits(vtkSMProxy* prototype)
{
  pqOutputPort* port = pqActiveObjects::instance().activePort();
  auto* input =
    prototype ? vtkSMInputProperty::SafeDownCast(prototype->GetProperty("Input")) : nullptr;
  if (!port || !input || port->getSource()->modifiedState() == pqProxy::UNINITIALIZED)
  {
    return false;
  }
  input->RemoveAllUncheckedProxies();
  input->AddUncheckedInputConnection(
    port->getSource()->getProxy(), static_cast<unsigned int>(port->getPortNumber()));
  const bool fits = input->IsInDomains() != 0;
  input->RemoveAllUncheckedProxies();
  return fits;
}

/// The entries get the names of the filters, and are enabled, when the menu opens.
void AddFilters(QMenu* menu, const QStringList& filters)
{
  QList<QAction*> actions;
  for (const QString& filter : filters)
  {
    QAction* action = menu->addAction(filter);
    action->setData(filter);
    action->setObjectName(filter);
    QObject::connect(action, &QAction::triggered, menu,
      [filter] { pqFiltersMenuReaction::createFilter("filters", filter); });
    actions << action;
  }
  QObject::connect(menu, &QMenu::aboutToShow, menu,
    [actions]
    {
      for (QAction* action : actions)
      {
        vtkSMProxy* prototype = FindPrototype(action->data().toString());
        action->setEnabled(Fits(prototype));
        if (prototype)
        {
          action->setText(prototype->GetXMLLabel());
          const char* help = prototype->GetDocumentation()->GetShortHelp();
          action->setStatusTip(help ? help : "");
        }
      }
    });
}

/// Background, scale bar and shadows of the views: entries of pipelines.change_look().
void AddLooks(QMenu* menu)
{
  const QList<QPair<const char*, const char*>> looks{ { "white", "White background" },
    { "light", "Light background" }, { "dark", "Dark background" },
    { "standard", "Standard background" }, { "", "" }, { "scale_bar", "Scale bar on or off" },
    { "soft_shadows", "Soft shadows on or off" } };
  for (const auto& [name, title] : looks)
  {
    if (QString(name).isEmpty())
    {
      menu->addSeparator();
      continue;
    }
    QAction* action = menu->addAction(title);
    action->setObjectName(QString("Look_%1").arg(name));
    const QString call = QString("change_look(\"%1\")").arg(name);
    QObject::connect(action, &QAction::triggered, menu, [call] { isthmus::RunPipelines(call); });
  }
}

/// All by their tasks, in a menu of the window's bar, before Help.
void AddMenu(QMainWindow* window, const QList<QAction*>& buttons)
{
  QMenuBar* bar = window->menuBar();
  if (bar->findChild<QMenu*>("menuIsthmus"))
  {
    return;
  }
  auto* menu = new QMenu("&Isthmus", bar);
  menu->setObjectName("menuIsthmus");
  for (const Task& task : Tasks())
  {
    QMenu* submenu = menu->addMenu(task.Title);
    submenu->setObjectName(QString(task.Title).remove(',').replace(' ', '_'));
    submenu->menuAction()->setObjectName(submenu->objectName());
    for (QAction* button : buttons)
    {
      if (task.Buttons.contains(button->objectName().mid(QString("Isthmus_").size())))
      {
        submenu->addAction(button);
      }
    }
    submenu->addSection("Filters");
    AddFilters(submenu, task.Filters);
  }
  menu->addSeparator();
  QMenu* look = menu->addMenu("Look of the view");
  look->setObjectName("Look_of_the_view");
  look->menuAction()->setObjectName(look->objectName());
  AddLooks(look);
  QAction* compare = menu->addAction("Compare in a second view");
  compare->setObjectName("Compare");
  compare->setStatusTip("Moves what is shown of the selected source to a second view, with linked "
                        "cameras and one range of colours");
  QObject::connect(
    compare, &QAction::triggered, window, [] { isthmus::RunPipelines("compare()"); });
  QAction* figure = menu->addAction("Save figure...");
  figure->setObjectName("Save_figure");
  QObject::connect(figure, &QAction::triggered, window,
    [window]
    {
      IsthmusFigureDialog dialog(window);
      dialog.exec();
    });
  QAction* helpers = menu->addAction("Show helpers in the pipeline browser");
  helpers->setObjectName("Show_helpers");
  helpers->setCheckable(true);
  helpers->setStatusTip("Lists all filters that buttons have made, and links to further inputs");
  QObject::connect(helpers, &QAction::toggled, window,
    [](bool shows) { IsthmusBrowser::Instance().ShowAll(shows); });
  auto* help = bar->findChild<QMenu*>("menu_Help");
  bar->insertMenu(help ? help->menuAction() : nullptr, menu);
}

void UpdateToolbar(const QList<QAction*>& actions)
{
  if (auto* window = qobject_cast<QMainWindow*>(pqCoreUtilities::mainWidget()))
  {
    MoveToLastRow(window);
    AddMenu(window, actions);
    IsthmusBrowser::Instance().Attach(window);
  }
}

}

IsthmusToolbar::IsthmusToolbar(QObject* parent)
  : QActionGroup(parent)
{
  this->setExclusive(false);
  // Once ParaView has made the toolbar: when the program starts, or when the plugin is loaded
  // later.
  QObject::connect(pqApplicationCore::instance(), &pqApplicationCore::clientEnvironmentDone, this,
    [this] { UpdateToolbar(this->actions()); });
  QTimer::singleShot(0, this, [this] { UpdateToolbar(this->actions()); });
  this->Add("map_to_surface", "MapToSurface", tr("Map to surface"),
    tr("The selected map as a closed surface at an automatic level, without dust"));
  this->Add("map_to_curvature", "MapToCurvature", tr("Map to curvature"),
    tr("The selected map as a surface coloured by its mean curvature"));
  this->Add("map_to_loops", "MapToLoops", tr("Map to choking loops"),
    tr("Where the surface of the selected map is narrow: handles, tunnels, bottlenecks"));
  this->Add("protein_to_surface", "ProteinToSurface", tr("Protein to surface"),
    tr("The molecular surface of the selected protein"));
  this->Add("protein_to_sites", "ProteinToSites", tr("Protein to potential and sites"),
    tr("Potential, polarized curvature and likely binding sites of the selected protein"));
  this->Add("surface_to_loops", "SurfaceToLoops", tr("Surface to choking loops"),
    tr("Where the selected closed surface is narrow: handles, tunnels, bottlenecks"));
  this->Add("persistence_diagram", "Diagram", tr("Persistence diagram"),
    tr("The diagram of the selected Choking Loops or Scalar Persistence, as a chart"));
  this->Add("protein_to_pockets", "ProteinToPockets", tr("Protein to pockets"),
    tr("The pockets of the selected molecule, ranked; a click on one shows its residues"));
  this->Add("protein_to_pores", "ProteinToPores", tr("Protein to pores"),
    tr("Channels that run through the selected molecule, with the radius along them"));
  this->Add("map_with_model", "MapWithModel", tr("Map with model"),
    tr("The selected map coloured by the chains of the molecule that is open, and whether that is "
       "fitted"));
  this->Add("trajectory_to_loops", "TrajectoryToLoops", tr("Trajectory to loops over time"),
    tr("Choking loops in each frame of the selected trajectory, with a chart of their radius over "
       "time"));
  const auto show = [this](const char* name, const char* icon, const QString& text,
                      const QString& tip, const char* call)
  {
    QObject::connect(this->Make(name, icon, text, tip), &QAction::triggered, this,
      [call] { isthmus::RunPipelines(call); });
  };
  show("selected_loops", "SelectedLoops", tr("Show only the selected loops"),
    tr("Hides all choking loops except those selected in the table or the view"),
    "show_loops(True)");
  show("all_loops", "AllLoops", tr("Show all loops"), tr("Shows all choking loops again"),
    "show_loops(False)");
}

QAction* IsthmusToolbar::Make(
  const char* name, const char* icon, const QString& text, const QString& tip)
{
  auto* action = new QAction(QIcon(QString(":/Isthmus/%1.svg").arg(icon)), text, this);
  action->setObjectName(QString("Isthmus_%1").arg(name));
  action->setToolTip("<b>" + text + "</b><br>" + tip);
  action->setStatusTip(tip);
  return action;
}

void IsthmusToolbar::Add(
  const char* function, const char* icon, const QString& text, const QString& tip)
{
  const QString call = QString("run(\"%1\")").arg(function);
  QObject::connect(this->Make(function, icon, text, tip), &QAction::triggered, this,
    [call, text] { Run(call, text); });
}
