package org.evoloop.check;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** How the rules and the properties may depend on each other and on other modules. */
@AnalyzeClasses(packages = "org.evoloop.check", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule theRulesKnowNothingOfProperties = noClasses()
            .that()
            .resideInAPackage("org.evoloop.check")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("org.evoloop.check.temporal..", "org.evoloop.engine..");

    @ArchTest
    static final ArchRule nothingIsReadOrWritten = noClasses()
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("java.nio.file..", "java.io..", "org.slf4j..");

    @ArchTest
    static final ArchRule noConverterIsNeeded = noClasses()
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("org.evoloop.converter..", "org.evoloop.loop..", "org.evoloop.function..");
}
