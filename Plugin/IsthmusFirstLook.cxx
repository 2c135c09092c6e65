#include "IsthmusFirstLook.h"

#include "RunPython.h"

#include <pqApplicationCore.h>
#include <pqDataRepresentation.h>
#include <pqPipelineSource.h>
#include <pqServerManagerModel.h>

#include <vtkSMProxy.h>

#include <QTimer>

IsthmusFirstLook::IsthmusFirstLook(QObject* parent)
  : QObject(parent)
{
}

void IsthmusFirstLook::Start()
{
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(
    model, &pqServerManagerModel::representationAdded, this, &IsthmusFirstLook::Follow);
  QObject::connect(
    model, &pqServerManagerModel::sourceAdded, this, &IsthmusFirstLook::SetFirstValues);
}

void IsthmusFirstLook::Stop()
{
  QObject::disconnect(
    pqApplicationCore::instance()->getServerManagerModel(), nullptr, this, nullptr);
  this->Waiting.clear();
}

void IsthmusFirstLook::Follow(pqRepresentation* added)
{
  auto* representation = qobject_cast<pqDataRepresentation*>(added);
  if (!representation)
  {
    return;
  }
  const auto look = [this, representation] { this->LookSoon(representation); };
  QObject::connect(representation, &pqDataRepresentation::dataUpdated, this, look);
  QObject::connect(representation, &pqDataRepresentation::colorArrayNameModified, this, look);
  QObject::connect(representation, &QObject::destroyed, this,
    [this, representation] { this->Waiting.remove(representation); });
}

// ParaView itself is still choosing colours when it tells of them.
void IsthmusFirstLook::LookSoon(pqDataRepresentation* representation)
{
  if (this->Waiting.isEmpty())
  {
    QTimer::singleShot(0, this, [this] { this->Look(); });
  }
  this->Waiting.insert(representation);
}

// The menu has to be done with it first, and a script, which may give it values of its own.
void IsthmusFirstLook::SetFirstValues(pqPipelineSource* source)
{
  QTimer::singleShot(0, source,
    [source]
    {
      if (source->modifiedState() != pqProxy::UNINITIALIZED)
      {
        return; // of a state file, or a script's: it has its values
      }
      const QString id = QString::number(source->getProxy()->GetGlobalID());
      isthmus::RunPipelines("first_values(" + id + ')');
    });
}

void IsthmusFirstLook::Look()
{
  QStringList ids;
  for (pqDataRepresentation* representation : this->Waiting)
  {
    ids << QString::number(representation->getProxy()->GetGlobalID());
  }
  this->Waiting.clear();
  if (!ids.isEmpty())
  {
    isthmus::RunPipelines("first_look(" + ids.join(", ") + ')');
  }
}
