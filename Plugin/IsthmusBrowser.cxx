#include "IsthmusBrowser.h"

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

bool IsOurs(pqPipelineSource* source)
{
  vtkSMProxy* proxy = source->getProxy();
  vtkPVXMLElement* hints = proxy->GetHints();
  vtkPVXMLElement* entry = hints ? hints->FindNestedElementByName("ShowInMenu") : nullptr;
  const char* category = entry ? entry->GetAttribute("category") : nullptr;
  return proxy->HasAnnotation(Annotation) || (category && std::strstr(category, "Isthmus"));
}

bool IsFurtherInput(pqPipelineSource* source, pqPipelineSource* sink, int port)
{
  vtkSMInputProperty* main = IsOurs(sink) ? MainInput(sink) : nullptr;
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

void IsthmusBrowser::Attach(QWidget* window)
{
  auto* browser = window->findChild<pqPipelineBrowserWidget*>();
  if (this->Model || !browser)
  {
    return;
  }
  this->Model = browser->findChild<pqPipelineModel*>();
  if (!this->Model)
  {
    return;
  }
  pqServerManagerModel* sources = Sources();
  using Connection =
    void (pqServerManagerModel::*)(pqPipelineSource*, pqPipelineSource*, int);
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

/// The output of a source, or, of a hidden one, that from which it is made; none if that is unknown.
IsthmusBrowser::Port IsthmusBrowser::Listed(pqPipelineSource* source, int port) const
{
  while (source && this->IsHidden(source))
  {
    vtkSMInputProperty* main = MainInput(source);
    const bool hasInput = main && main->GetNumberOfProxies() > 0;
    port = hasInput ? static_cast<int>(main->GetOutputPortForConnection(0)) : 0;
    source = hasInput ? Sources()->findItem<pqPipelineSource*>(main->GetProxy(0)) : nullptr;
  }
  return { source, port };
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
  const Port listed = this->Listed(source, port);
  if (listed.first)
  {
    this->Connections[{ source, sink, port }] = listed;
    this->Model->addConnection(listed.first, sink, listed.second);
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
      const Port listed = this->Listed(hidden, 0);
      if (listed.first && pqActiveObjects::instance().activeSource() == hidden)
      {
        pqActiveObjects::instance().setActivePort(listed.first->getOutputPort(listed.second));
      }
    });
}
