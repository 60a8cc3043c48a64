package org.evoloop.page;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** The dependencies between the packages of the page module. */
@AnalyzeClasses(packages = "org.evoloop.page", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule drawingsKnowMachinesAndTheirPairsAlone = noClasses()
            .that()
            .resideInAPackage("org.evoloop.page.drawing")
            .should()
            .dependOnClassesThat()
            .resideOutsideOfPackages(
                    "org.evoloop.page.drawing",
                    "org.evoloop.evolution",
                    "org.evoloop.statemachine",
                    "java.util..",
                    "java.lang..",
                    "org.jspecify..");

    @ArchTest
    static final ArchRule onlyClocksLookAtTheMachinesTime = noClasses()
            .should()
            .callMethod(System.class, "nanoTime")
            .orShould()
            .callMethod(System.class, "currentTimeMillis");
}
