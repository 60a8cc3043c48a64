package org.evoloop.gpio;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** Which classes may use the library that drives the pins. */
@AnalyzeClasses(packages = "org.evoloop.gpio", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule providersAreKnownInOnePlace = noClasses()
            .that()
            .haveNameNotMatching(".*\\.Pins(\\$.*)?")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("com.pi4j.plugin..", "com.pi4j.context..");
}
