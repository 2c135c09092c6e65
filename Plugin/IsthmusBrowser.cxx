#include "IsthmusBrowser.h"

#include "IsthmusProgress.h"

#include <pqActiveObjects.h>
#include <pqApplicationCore.h>
#include <pqOutputPort.h>
#include <pqPipelineBrowserWidget.h>
#include <pqPipelineModel.h>
#include <pqPipelineSource.h>
#include <pqServerManagerModel.h>

#include <vtkPVXMLElement.h>
#include <vtkSMInputProperty.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>

#include <QSortFilterProxyModel>
#include <QTimer>

#include <cstring>

namespace
{

constexpr const char* Annotation = "IsthmusEntry";

pqServerManagerModel* Sources()
{
  return pqApplicationCore::instance()->getServerManagerModel();
}

vtkSMInputProperty* MainInput(pqPipelineSource* source)
{
  return vtkSMInputProperty::SafeDownCast(source->getProxy()->GetProperty("Input"));
}

bool IsFurtherInput(pqPipelineSource* source, pqPipelineSource* sink, int port)
{
  vtkSMInputProperty* main = IsthmusBrowser::IsOurs(sink->getProxy()) ? MainInput(sink) : nullptr;
  for (unsigned int i = 0; main && i < main->GetNumberOfProxies(); ++i)
  {
    if (main->GetProxy(i) == source->getProxy() &&
      static_cast<int>(main->GetOutputPortForConnection(i)) == port)
    {
      return i > 0;
    }
  }
  return main && main->GetNumberOfProxies() > 0;
}

}

IsthmusBrowser& IsthmusBrowser::Instance()
{
  // Lives as long as the application, which it uses in the destructor.
  static IsthmusBrowser* const instance = new IsthmusBrowser;
  return *instance;
}

bool IsthmusBrowser::IsOurs(vtkSMProxy* proxy)
{
  vtkPVXMLElement* hints = proxy->GetHints();
  vtkPVXMLElement* entry = hints ? hints->FindNestedElementByName("ShowInMenu") : nullptr;
  const char* category = entry ? entry->GetAttribute("category") : nullptr;
  return proxy->HasAnnotation(Annotation) || (category && std::strstr(category, "Isthmus"));
}

void IsthmusBrowser::Attach(QWidget* window)
{
  this->Browser = window->findChild<pqPipelineBrowserWidget*>();
  if (this->Model || !this->Browser)
  {
    return;
  }
  this->Model = this->Browser->findChild<pqPipelineModel*>();
  if (!this->Model)
  {
    return;
  }
  pqServerManagerModel* sources = Sources();
  using Connection = void (pqServerManagerModel::*)(pqPipelineSource*, pqPipelineSource*, int);
  const Connection added = &pqServerManagerModel::connectionAdded;
  const Connection removed = &pqServerManagerModel::connectionRemoved;
  QObject::disconnect(sources, &pqServerManagerModel::sourceAdded, this->Model, nullptr);
  QObject::disconnect(sources, added, this->Model, nullptr);
  QObject::disconnect(sources, removed, this->Model, nullptr);
  QObject::connect(sources, &pqServerManagerModel::sourceAdded, this, &IsthmusBrowser::AddSource);
  QObject::connect(sources, added, this, &IsthmusBrowser::AddConnection);
  QObject::connect(sources, removed, this, &IsthmusBrowser::RemoveConnection);
  QObject::connect(&pqActiveObjects::instance(), &pqActiveObjects::sourceChanged, this,
    &IsthmusBrowser::LeaveHidden);
  this->ShowAll(false);
}

void IsthmusBrowser::ShowAll(bool shows)
{
  if (!this->Model)
  {
    return;
  }
  const auto sources = Sources()->findItems<pqPipelineSource*>();
  for (pqPipelineSource* source : sources)
  {
    this->Model->removeSource(source);
  }
  this->Connections.clear();
  this->ShowsAll = shows;
  for (pqPipelineSource* source : sources)
  {
    this->AddSource(source);
  }
  for (pqPipelineSource* source : sources)
  {
    for (int port = 0; port < source->getNumberOfOutputPorts(); ++port)
    {
      for (int i = 0; i < source->getNumberOfConsumers(port); ++i)
      {
        this->AddConnection(source, source->getConsumer(port, i), port);
      }
    }
  }
}

bool IsthmusBrowser::IsHidden(pqPipelineSource* source) const
{
  const char* entry = source->getProxy()->GetAnnotation(Annotation);
  return !this->ShowsAll && entry && std::strcmp(entry, "hidden") == 0;
}

bool IsthmusBrowser::IsCollapsed(pqPipelineSource* source) const
{
  return !this->ShowsAll && source->getNumberOfOutputPorts() > 1 && IsOurs(source->getProxy()) &&
    this->Above(source).first;
}

QModelIndex IsthmusBrowser::IndexOf(pqPipelineSource* source) const
{
  const auto* shown = qobject_cast<QSortFilterProxyModel*>(this->Browser->getModel());
  return shown ? shown->mapFromSource(this->Model->getIndexFor(source)) : QModelIndex();
}

// ParaView expands an entry that becomes the selected one, also some time later, so that a button
// must have ended.
void IsthmusBrowser::Collapse(pqPipelineSource* source)
{
  constexpr int delay = 300; // ms
  const QPointer<pqPipelineSource> collapsed(source);
  QTimer::singleShot(delay, this,
    [this, collapsed]
    {
      if (collapsed && IsthmusProgress::Instance().IsRunning())
      {
        this->Collapse(collapsed);
      }
      else if (this->Browser && this->Model && collapsed && this->IsCollapsed(collapsed))
      {
        this->Browser->collapse(this->IndexOf(collapsed));
      }
    });
}

/// The output of which a source is made; none if that is unknown.
IsthmusBrowser::Port IsthmusBrowser::Above(pqPipelineSource* source) const
{
  vtkSMInputProperty* main = MainInput(source);
  if (!main || main->GetNumberOfProxies() == 0)
  {
    return { nullptr, 0 };
  }
  return { Sources()->findItem<pqPipelineSource*>(main->GetProxy(0)),
    static_cast<int>(main->GetOutputPortForConnection(0)) };
}

/// The output of a source, or, of one without an entry for it, that from which it is made.
IsthmusBrowser::Port IsthmusBrowser::Listed(
  pqPipelineSource* source, int port, bool isForChild) const
{
  Port listed{ source, port };
  while (listed.first &&
    (this->IsHidden(listed.first) || (isForChild && this->IsCollapsed(listed.first))))
  {
    listed = this->Above(listed.first);
  }
  return listed;
}

void IsthmusBrowser::AddSource(pqPipelineSource* source)
{
  if (this->Model && !this->IsHidden(source))
  {
    this->Model->addSource(source);
  }
}

void IsthmusBrowser::AddConnection(pqPipelineSource* source, pqPipelineSource* sink, int port)
{
  if (!this->Model || this->IsHidden(sink) ||
    (!this->ShowsAll && IsFurtherInput(source, sink, port)))
  {
    return;
  }
  const Port listed = this->Listed(source, port, true);
  if (listed.first)
  {
    this->Connections[{ source, sink, port }] = listed;
    this->Model->addConnection(listed.first, sink, listed.second);
    this->Collapse(sink);
  }
}

void IsthmusBrowser::RemoveConnection(pqPipelineSource* source, pqPipelineSource* sink, int port)
{
  const auto found = this->Connections.find({ source, sink, port });
  if (found == this->Connections.end())
  {
    return;
  }
  const Port listed = found->second;
  this->Connections.erase(found);
  if (this->Model && listed.first)
  {
    this->Model->removeConnection(listed.first, sink, listed.second);
  }
}

// Its panel would be shown otherwise, which also marks it as modified.
void IsthmusBrowser::LeaveHidden(pqPipelineSource* source)
{
  if (!source || !this->IsHidden(source))
  {
    return;
  }
  const QPointer<pqPipelineSource> hidden(source);
  QTimer::singleShot(0, this,
    [this, hidden]
    {
      if (!hidden)
      {
        return;
      }
      hidden->setModifiedState(pqProxy::UNMODIFIED);
      const Port listed = this->Listed(hidden, 0, false);
      if (!listed.first || pqActiveObjects::instance().activeSource() != hidden)
      {
        return;
      }
      const bool isOpen =
        this->Browser && this->Browser->isIndexExpanded(this->IndexOf(listed.first));
      pqActiveObjects::instance().setActivePort(listed.first->getOutputPort(listed.second));
      if (!isOpen)
      {
        this->Collapse(listed.first);
      }
    });
}
