/**
 * @file IsthmusInitialization.cxx
 * @brief Initialization of the plugin: its Python modules can be imported, and new
 * filters get values that are proposed from the data.
 *
 * A value that is automatic unless given (Core/FilterProperties.h) is two properties of a panel, a
 * number and a switch. This hint of their proxy switches the latter off when the number is set, in
 * the call that makes the filter as well as later, also of filters that a state file has made:
 *
 *     <InitializationHelper class="vtkSMIsthmusInitialization"
 *       property="AutomaticLevel" unless="Level"/>
 *
 * ParaView replaces a property that a domain proposes a value for unless the property was modified
 * in the call that makes the filter. Setting the value that the property has already modifies
 * nothing, so that MapSurface(Input=map, Level=0.0) would contour the middle of the range. Without
 * a default (default_values="none") setting any value is a modification. The default is in a hint
 * of the property, and is set where there are no data to propose a value from:
 *
 *     <DefaultWithoutData values="0.0"/>
 *
 * This happens for each proxy with an InitializationHelper of this class, after that of `property`;
 * the helper without attributes does nothing else.
 */
#include <vtkCallbackCommand.h>
#include <vtkClientServerInterpreter.h>
#include <vtkClientServerInterpreterInitializer.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPVDataInformation.h>
#include <vtkPVXMLElement.h>
#include <vtkProcessModule.h>
#include <vtkPythonInterpreter.h>
#include <vtkSMDomain.h>
#include <vtkSMDomainIterator.h>
#include <vtkSMProperty.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMPropertyIterator.h>
#include <vtkSMProxy.h>
#include <vtkSMProxyInitializationHelper.h>
#include <vtkSMProxyManager.h>
#include <vtkSMSession.h>
#include <vtkSMSessionProxyManager.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMVectorProperty.h>
#include <vtkSession.h>
#include <vtkSessionIterator.h>
#include <vtkSmartPointer.h>

#include <dlfcn.h>

#include <string>
#include <vector>

namespace
{

constexpr const char* HelperName = "vtkSMIsthmusInitialization";

/// Calls `take(number, its switch)` for each number of the proxy that is automatic unless given.
template <typename Take>
void ForEachAutomatic(vtkSMProxy* proxy, Take&& take)
{
  vtkPVXMLElement* const hints = proxy->GetHints();
  for (unsigned int i = 0; hints && i < hints->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* const hint = hints->GetNestedElement(i);
    vtkSMProperty* const number = proxy->GetProperty(hint->GetAttributeOrEmpty("unless"));
    vtkSMProperty* const automatic = proxy->GetProperty(hint->GetAttributeOrEmpty("property"));
    if (std::string(hint->GetAttributeOrEmpty("class")) == HelperName && number && automatic)
    {
      take(number, automatic);
    }
  }
}

/// Whether `hint` is the first hint of the proxy for this helper, which handles all of them at
/// once: its proposals would count as given values for the next one.
bool IsFirst(vtkSMProxy* proxy, vtkPVXMLElement* hint)
{
  vtkPVXMLElement* const hints = proxy->GetHints();
  for (unsigned int i = 0; hints && i < hints->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* const other = hints->GetNestedElement(i);
    if (std::string(other->GetAttributeOrEmpty("class")) == HelperName)
    {
      return other == hint;
    }
  }
  return true;
}

/// A number has been set: it is no longer automatic. Resetting it to its default does not count.
void SwitchOff(vtkObject* caller, unsigned long, void*, void*)
{
  auto* const changed = vtkSMProperty::SafeDownCast(caller);
  if (!changed || !changed->GetParent() || changed->IsValueDefault())
  {
    return;
  }
  ForEachAutomatic(changed->GetParent(),
    [changed](vtkSMProperty* number, vtkSMProperty* automatic)
    {
      if (number == changed)
      {
        vtkSMPropertyHelper(automatic).Set(0);
      }
    });
}

/// A proxy has been registered, whether made or loaded: its numbers are observed from now on.
void ObserveNumbers(vtkObject*, unsigned long, void*, void* data)
{
  static const auto command = []()
  {
    auto made = vtkSmartPointer<vtkCallbackCommand>::New();
    made->SetCallback(SwitchOff);
    return made;
  }();
  const auto* const registered = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
  if (registered && registered->Proxy)
  {
    ForEachAutomatic(registered->Proxy,
      [](vtkSMProperty* number, vtkSMProperty*)
      {
        if (!number->HasObserver(vtkCommand::ModifiedEvent, command))
        {
          number->AddObserver(vtkCommand::ModifiedEvent, command);
        }
      });
  }
}

void ObserveSession(vtkSession* session)
{
  auto* const managed = vtkSMSession::SafeDownCast(session);
  vtkSMSessionProxyManager* const proxies = managed ? managed->GetSessionProxyManager() : nullptr;
  if (proxies)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(ObserveNumbers);
    proxies->AddObserver(vtkCommand::RegisterEvent, command);
  }
}

/// Observes the existing and all future sessions.
void ObserveSessions()
{
  vtkProcessModule* const process = vtkProcessModule::GetProcessModule();
  if (!process)
  {
    return;
  }
  const auto sessions = vtkSmartPointer<vtkSessionIterator>::Take(process->NewSessionIterator());
  for (sessions->InitTraversal(); !sessions->IsDoneWithTraversal(); sessions->GoToNextItem())
  {
    ObserveSession(sessions->GetCurrentSession());
  }
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(
    [](vtkObject*, unsigned long, void*, void* id)
    {
      ObserveSession(
        vtkProcessModule::GetProcessModule()->GetSession(*static_cast<vtkIdType*>(id)));
    });
  process->AddObserver(vtkCommand::ConnectionCreatedEvent, command);
}

/// Whether there are data: without, ParaView proposes a share of the extent of bounds from 1 to -1.
bool HasBounds(vtkSMProperty* input)
{
  const vtkSMPropertyHelper helper(input, true);
  auto* source = input ? vtkSMSourceProxy::SafeDownCast(helper.GetAsProxy(0)) : nullptr;
  return source &&
    vtkMath::AreBoundsInitialized(
      source->GetDataInformation(helper.GetOutputPort(0))->GetBounds()) != 0;
}

void Propose(vtkSMProperty* property, vtkMTimeType made)
{
  const auto domains = vtkSmartPointer<vtkSMDomainIterator>::Take(property->NewDomainIterator());
  for (domains->Begin(); !domains->IsAtEnd(); domains->Next())
  {
    vtkSMDomain* domain = domains->GetDomain();
    if (!HasBounds(domain->GetRequiredProperty("Input")))
    {
      continue;
    }
    // Reset the array first: the default of the property is the range of that array.
    vtkSMProperty* array = domain->GetRequiredProperty("ArraySelection");
    if (array && array->GetMTime() <= made)
    {
      array->ResetToDomainDefaults();
    }
    property->ResetToDomainDefaults();
  }
}

void SetDefault(vtkSMProperty* property, vtkPVXMLElement* hint, vtkMTimeType made)
{
  std::vector<double> values(vtkSMVectorProperty::SafeDownCast(property)->GetNumberOfElements());
  hint->GetVectorAttribute("values", static_cast<int>(values.size()), values.data());
  const auto count = static_cast<unsigned int>(values.size());
  vtkSMPropertyHelper(property).Set(values.data(), count);
  Propose(property, made);
}

void SetDefaults(vtkSMProxy* proxy, vtkMTimeType made)
{
  const auto properties =
    vtkSmartPointer<vtkSMPropertyIterator>::Take(proxy->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    vtkSMProperty* property = properties->GetProperty();
    vtkPVXMLElement* hints = property->GetHints();
    vtkPVXMLElement* hint = hints ? hints->FindNestedElementByName("DefaultWithoutData") : nullptr;
    if (hint && property->GetMTime() <= made)
    {
      SetDefault(property, hint, made);
    }
  }
}

}

class vtkSMIsthmusInitialization : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMIsthmusInitialization* New();
  vtkTypeMacro(vtkSMIsthmusInitialization, vtkSMProxyInitializationHelper);

  void PostInitializeProxy(vtkSMProxy* proxy, vtkPVXMLElement* hint, vtkMTimeType made) override
  {
    if (!IsFirst(proxy, hint))
    {
      return;
    }
    ForEachAutomatic(proxy,
      [made](vtkSMProperty* number, vtkSMProperty* automatic)
      {
        if (number->GetMTime() > made && automatic->GetMTime() <= made)
        {
          vtkSMPropertyHelper(automatic).Set(0);
        }
      });
    SetDefaults(proxy, made);
  }
};

vtkStandardNewMacro(vtkSMIsthmusInitialization);

namespace
{

vtkObjectBase* NewInitialization(void*)
{
  return vtkSMIsthmusInitialization::New();
}

void RegisterInitialization(vtkClientServerInterpreter* interpreter)
{
  interpreter->AddNewInstanceFunction(HelperName, NewInitialization);
}

/// The package isthmus_plugin is in the folder python beside this library.
void AddPythonModules()
{
  Dl_info library;
  if (dladdr(reinterpret_cast<const void*>(&AddPythonModules), &library) != 0)
  {
    const std::string file = library.dli_fname;
    vtkPythonInterpreter::PrependPythonPath(
      (file.substr(0, file.find_last_of('/') + 1) + "python").c_str());
  }
}

/// Runs when the plugin is loaded.
const bool registered = []()
{
  AddPythonModules();
  ObserveSessions();
  vtkClientServerInterpreterInitializer::GetInitializer()->RegisterCallback(RegisterInitialization);
  return true;
}();

}
