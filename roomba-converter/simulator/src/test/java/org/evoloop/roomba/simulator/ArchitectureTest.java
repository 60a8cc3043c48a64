package org.evoloop.roomba.simulator;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideOutsideOfPackages;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.dependencies.SlicesRuleDefinition;

/** The simulator's packages; its module-info says which other modules it may use, of the core only some packages. */
@AnalyzeClasses(packages = "org.evoloop.roomba.simulator", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule nothingOfTheConverterIsKnown = noClasses()
            .should()
            .dependOnClassesThat(resideInAPackage("org.evoloop..")
                    .and(resideOutsideOfPackages(
                            "org.evoloop.roomba.simulator..",
                            "org.evoloop.roomba.oi..",
                            "org.evoloop.natives..",
                            "org.evoloop.time..")));

    @ArchTest
    static final ArchRule noRoomsLeadInACircle = SlicesRuleDefinition.slices()
            .matching("org.evoloop.roomba.simulator.(*)..")
            .should()
            .beFreeOfCycles();
}
