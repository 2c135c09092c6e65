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
 * a filter first and set properties then.
 */
#include <vtkCallbackCommand.h>
#include <vtkClientServerInterpreter.h>
#include <vtkClientServerInterpreterInitializer.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPVXMLElement.h>
#include <vtkPythonInterpreter.h>
#include <vtkSMProperty.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>
#include <vtkSMProxyInitializationHelper.h>
#include <vtkWeakPointer.h>

#include <dlfcn.h>

#include <string>

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

}

class vtkSMIsthmusInitialization : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMIsthmusInitialization* New();
  vtkTypeMacro(vtkSMIsthmusInitialization, vtkSMProxyInitializationHelper);

  void PostInitializeProxy(vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType made) override
  {
    vtkSMProperty* property = proxy->GetProperty(xml->GetAttributeOrEmpty("property"));
    vtkSMProperty* other = proxy->GetProperty(xml->GetAttributeOrEmpty("unless"));
    int value = 0, otherwise = 0;
    if (!property || !other || property->GetMTime() > made ||
      !xml->GetScalarAttribute("value", &value) ||
      !xml->GetScalarAttribute("otherwise", &otherwise))
    {
      return;
    }
    const bool isSet = other->GetMTime() > made;
    vtkSMPropertyHelper(property).Set(isSet ? otherwise : value);
    if (!isSet)
    {
      vtkNew<vtkCallbackCommand> command;
      command->SetCallback(FollowOther);
      command->SetClientData(new Follower{ property, property->GetMTime(), otherwise });
      command->SetClientDataDeleteCallback([](void* data) { delete static_cast<Follower*>(data); });
      other->AddObserver(vtkCommand::ModifiedEvent, command);
    }
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
