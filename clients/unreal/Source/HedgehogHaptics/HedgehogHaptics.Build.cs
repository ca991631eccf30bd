// SPDX-License-Identifier: MIT
using UnrealBuildTool;

public class HedgehogHaptics : ModuleRules
{
    public HedgehogHaptics(ReadOnlyTargetRules Target) : base(Target)
    {
        PCHUsage = PCHUsageMode.UseExplicitOrSharedPCHs;
        PublicDependencyModuleNames.AddRange(new string[] { "Core", "CoreUObject", "Engine" });
        PrivateDependencyModuleNames.Add("Sockets");
    }
}
