/**
 * @file IsthmusBrowser.h
 * @brief Entries of the pipeline browser: one for each source, none for the helpers of buttons.
 *
 * Sources that buttons have made have the annotation IsthmusEntry (entries.py). Those with the
 * value "hidden" have no entry; what is made from them is listed below the source that they are
 * made from. A filter of Isthmus with several inputs is listed below its main one only, where
 * ParaView would list it once more and a link below each input. One with several outputs is
 * collapsed, and what is made from it is listed beside it. If a hidden source becomes the active
 * one, such as by a click in its table, the source above it does instead.
 */
#ifndef IsthmusBrowser_h
#define IsthmusBrowser_h

#include <QModelIndex>
#include <QObject>
#include <QPointer>

#include <map>
#include <tuple>
#include <utility>

class QWidget;
class pqPipelineBrowserWidget;
class pqPipelineModel;
class pqPipelineSource;
class vtkSMProxy;

class IsthmusBrowser : public QObject
{
  Q_OBJECT

public:
  static IsthmusBrowser& Instance();

  /// Whether a filter is one of Isthmus, or was made by one of its buttons.
  static bool IsOurs(vtkSMProxy* proxy);

  /// Takes over the entries of the window's pipeline browser.
  void Attach(QWidget* window);

  /// Whether hidden sources and links are listed, too.
  void ShowAll(bool shows);

private:
  using Port = std::pair<QPointer<pqPipelineSource>, int>;

  IsthmusBrowser() = default;

  void AddSource(pqPipelineSource* source);
  void AddConnection(pqPipelineSource* source, pqPipelineSource* sink, int port);
  void RemoveConnection(pqPipelineSource* source, pqPipelineSource* sink, int port);
  void LeaveHidden(pqPipelineSource* source);
  void Collapse(pqPipelineSource* source);
  QModelIndex IndexOf(pqPipelineSource* source) const;
  bool IsHidden(pqPipelineSource* source) const;
  bool IsCollapsed(pqPipelineSource* source) const;
  Port Above(pqPipelineSource* source) const;
  Port Listed(pqPipelineSource* source, int port, bool isForChild) const;

  QPointer<pqPipelineBrowserWidget> Browser;
  QPointer<pqPipelineModel> Model;
  std::map<std::tuple<pqPipelineSource*, pqPipelineSource*, int>, Port> Connections; ///< listed
  bool ShowsAll = false;
};

#endif
