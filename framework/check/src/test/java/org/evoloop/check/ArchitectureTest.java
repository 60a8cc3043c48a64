package org.evoloop.check;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** What the rules and the properties may know of each other, and of the world. */
@AnalyzeClasses(packages = "org.evoloop.check", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule theRulesKnowNothingOfProperties = noClasses()
            .that()
            .resideInAPackage("org.evoloop.check")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("org.evoloop.check.temporal..", "org.evoloop.core..");

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
