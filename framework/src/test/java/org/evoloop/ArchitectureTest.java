package org.evoloop;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.Architectures;

/** The rooms of the framework and the arrows between them. */
@AnalyzeClasses(packages = "org.evoloop", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule arrowsRunDown = Architectures.layeredArchitecture()
            .consideringOnlyDependenciesInLayers()
            .layer("statemachine")
            .definedBy("org.evoloop.statemachine..")
            .layer("time")
            .definedBy("org.evoloop.time..")
            .layer("statechart")
            .definedBy("org.evoloop.statechart..")
            .optionalLayer("xmi")
            .definedBy("org.evoloop.xmi..")
            .layer("evolution")
            .definedBy("org.evoloop.evolution..")
            .layer("loop")
            .definedBy("org.evoloop.loop..")
            .layer("function")
            .definedBy("org.evoloop.function..")
            .layer("converter")
            .definedBy("org.evoloop.converter..")
            .optionalLayer("console")
            .definedBy("org.evoloop.console..")
            .whereLayer("statemachine")
            .mayNotAccessAnyLayer()
            .whereLayer("time")
            .mayNotAccessAnyLayer()
            .whereLayer("statechart")
            .mayOnlyAccessLayers("statemachine")
            .whereLayer("xmi")
            .mayOnlyAccessLayers("statechart", "statemachine")
            .whereLayer("evolution")
            .mayOnlyAccessLayers("statemachine")
            .whereLayer("loop")
            .mayOnlyAccessLayers("time")
            .whereLayer("function")
            .mayOnlyAccessLayers("loop", "time", "statemachine")
            .whereLayer("converter")
            .mayOnlyAccessLayers("loop", "function", "evolution", "time", "statemachine")
            .whereLayer("console")
            .mayOnlyAccessLayers("converter", "loop", "function", "evolution", "time", "statemachine");

    @ArchTest
    static final ArchRule decisionsArePure = noClasses()
            .that(resideInAnyPackage(
                    "org.evoloop.statemachine..", "org.evoloop.statechart..", "org.evoloop.evolution.."))
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("java.io..", "java.nio..", "java.net..", "org.slf4j..", "jakarta..")
            .orShould()
            .dependOnClassesThat()
            .areAssignableTo(Thread.class);

    @ArchTest
    static final ArchRule timeIsInjected = noClasses()
            .that(resideInAPackage("org.evoloop..")
                    .and(com.tngtech.archunit.base.DescribedPredicate.not(resideInAPackage("org.evoloop.time.."))))
            .should()
            .callMethod(System.class, "currentTimeMillis")
            .orShould()
            .callMethod(Thread.class, "sleep", long.class)
            .orShould()
            .callMethod(java.time.Instant.class, "now");

    @ArchTest
    static final ArchRule resultsAreNotPrintedByRoomsBelowTheConsole = noClasses()
            .that(com.tngtech.archunit.base.DescribedPredicate.not(resideInAPackage("org.evoloop.console..")))
            .should()
            .accessField(System.class, "out")
            .orShould()
            .accessField(System.class, "err");
}
