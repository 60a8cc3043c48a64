package org.evoloop;

import static com.tngtech.archunit.base.DescribedPredicate.alwaysTrue;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.dependencies.SlicesRuleDefinition;

/** The packages of the model readers and the dependencies between them. */
@AnalyzeClasses(
        packages = {"org.evoloop.statechart", "org.evoloop.xmi"},
        importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule noRoomsLeadInACircle =
            SlicesRuleDefinition.slices().matching("org.evoloop.(**)").should().beFreeOfCycles();

    @ArchTest
    static final ArchRule flatteningIsPure = noClasses()
            .that()
            .resideInAPackage("org.evoloop.statechart..")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage(
                    "org.evoloop.xmi..", "java.io..", "java.nio..", "java.net..", "org.slf4j..", "jakarta..");

    @ArchTest
    static final ArchRule noDialectKnowsAnother = SlicesRuleDefinition.slices()
            .matching("org.evoloop.xmi.(*)..")
            .should()
            .notDependOnEachOther()
            .ignoreDependency(alwaysTrue(), resideInAPackage("org.evoloop.xmi.dialect"));

    @ArchTest
    static final ArchRule nothingRunsByItself = noClasses()
            .should()
            .dependOnClassesThat()
            .areAssignableTo(Thread.class)
            .orShould()
            .dependOnClassesThat()
            .resideInAPackage("java.util.concurrent..");
}
