package org.evoloop.metrics;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** Metrics use a converter's status and none of its internals. */
@AnalyzeClasses(packages = "org.evoloop.metrics", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule onlyTheStatusIsLookedAt = noClasses()
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage(
                    "org.evoloop.engine..", "org.evoloop.statemachine..", "org.evoloop.evolution..", "java.io..");

    @ArchTest
    static final ArchRule registriesAreNotKnownToTheFigures = noClasses()
            .that()
            .haveSimpleName("ConverterMetrics")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("io.micrometer.prometheusmetrics..");
}
