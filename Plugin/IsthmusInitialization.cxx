/**
 * @file IsthmusInitialization.cxx
 * @brief What happens when the plugin is loaded: its Python modules can be imported, and new
 * filters get defaults that differ from those in state files.
 *
 * A property that did not exist when a state file was written is not in it. Where an added property
 * changes the result, the proxies that the file makes need the old behaviour, which they get by
 * default_values="none", since then nothing is sent and the VTK object decides. New filters get
 * their value from this hint of their proxy:
 *
 *     <InitializationHelper class="vtkSMIsthmusInitialization"
 *       property="AutomaticScale" value="1" otherwise="0" unless="Scale"/>
 *
 * `property` is set to `value`, unless it was set by whoever made the filter. It is set to
 * `otherwise` if the property `unless` was set, or will be set before `property` is: so scripts
 * that know the former only keep their results as well, also those of ParaView's trace, which make
 * a filter first and set properties then. Without `value`, `property` is set only to `otherwise`,
 * if `unless` was set in the call that made the filter.
 *
 * ParaView replaces a property that a domain proposes a value for unless the property was modified
 * in the call that makes the filter. Setting the value that the property has already modifies
 * nothing, so that MapSurface(Input=map, Level=0.0) would contour the middle of the range. Without
 * a default (default_values="none") setting any value is a modification. The default is in a hint
 * of the property, and is set where there are no data to propose a value from:
 *
 *     <DefaultWithoutData values="0.0" copy="ProposedLevel"/>
 *
 * The property `copy`, if there is one, gets the value that a new filter begins with, but not one
 * that was set by the caller. This happens for each proxy with an InitializationHelper of this
 * class, after that of `property`; the helper without attributes does nothing else.
 */
#include <vtkCallbackCommand.h>
#include <vtkClientServerInterpreter.h>
#include <vtkClientServerInterpreterInitializer.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPVDataInformation.h>
#include <vtkPVXMLElement.h>
#include <vtkPythonInterpreter.h>
#include <vtkSMDomain.h>
#include <vtkSMDomainIterator.h>
#include <vtkSMProperty.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMPropertyIterator.h>
#include <vtkSMProxy.h>
#include <vtkSMProxyInitializationHelper.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMVectorProperty.h>
#include <vtkSmartPointer.h>
#include <vtkWeakPointer.h>

#include <dlfcn.h>

#include <string>
#include <vector>

namespace
{

/// A property that keeps its value until another one is set, if nobody sets it before.
struct Follower
{
  vtkWeakPointer<vtkSMProperty> Property;
  vtkMTimeType Set = 0; ///< when it got its value
  int Otherwise = 0;
};

void FollowOther(vtkObject*, unsigned long, void* data, void*)
{
  auto* follower = static_cast<Follower*>(data);
  if (follower->Property && follower->Property->GetMTime() == follower->Set)
  {
    vtkSMPropertyHelper(follower->Property).Set(follower->Otherwise);
  }
}

void SetOneUnlessOther(vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType made)
{
  vtkSMProperty* property = proxy->GetProperty(xml->GetAttributeOrEmpty("property"));
  vtkSMProperty* other = proxy->GetProperty(xml->GetAttributeOrEmpty("unless"));
  int otherwise = 0;
  if (!property || !other || property->GetMTime() > made ||
    !xml->GetScalarAttribute("otherwise", &otherwise))
  {
    return;
  }
  if (other->GetMTime() > made)
  {
    vtkSMPropertyHelper(property).Set(otherwise);
    return;
  }
  int value = 0;
  if (xml->GetScalarAttribute("value", &value))
  {
    vtkSMPropertyHelper(property).Set(value);
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(FollowOther);
    command->SetClientData(new Follower{ property, property->GetMTime(), otherwise });
    command->SetClientDataDeleteCallback([](void* data) { delete static_cast<Follower*>(data); });
    other->AddObserver(vtkCommand::ModifiedEvent, command);
  }
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
    // The array whose range is proposed is chosen before, as it would be afterwards.
    vtkSMProperty* array = domain->GetRequiredProperty("ArraySelection");
    if (array && array->GetMTime() <= made)
    {
      array->ResetToDomainDefaults();
    }
    property->ResetToDomainDefaults();
  }
}

void SetDefault(
  vtkSMProxy* proxy, vtkSMProperty* property, vtkPVXMLElement* hint, vtkMTimeType made)
{
  std::vector<double> values(vtkSMVectorProperty::SafeDownCast(property)->GetNumberOfElements());
  hint->GetVectorAttribute("values", static_cast<int>(values.size()), values.data());
  const auto count = static_cast<unsigned int>(values.size());
  vtkSMPropertyHelper(property).Set(values.data(), count);
  Propose(property, made);
  if (vtkSMProperty* copy = proxy->GetProperty(hint->GetAttributeOrEmpty("copy")))
  {
    copy->Copy(property);
  }
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
      SetDefault(proxy, property, hint, made);
    }
  }
}

}

class vtkSMIsthmusInitialization : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMIsthmusInitialization* New();
  vtkTypeMacro(vtkSMIsthmusInitialization, vtkSMProxyInitializationHelper);

  void PostInitializeProxy(vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType made) override
  {
    SetOneUnlessOther(proxy, xml, made);
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
  interpreter->AddNewInstanceFunction("vtkSMIsthmusInitialization", NewInitialization);
}

/// Python modules lie in the folder python beside this library.
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
  vtkClientServerInterpreterInitializer::GetInitializer()->RegisterCallback(RegisterInitialization);
  return true;
}();

}
