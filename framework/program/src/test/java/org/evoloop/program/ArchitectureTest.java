package org.evoloop.program;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** What a program may use. */
@AnalyzeClasses(packages = "org.evoloop.program", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule librariesBelongToTheModulesBehindIt = noClasses()
            .that()
            .resideOutsideOfPackage("org.evoloop.program.prometheus")
            .should()
            .dependOnClassesThat()
            .resideOutsideOfPackages("org.evoloop..", "java..", "org.jspecify..", "org.slf4j..");

    @ArchTest
    static final ArchRule itKnowsNoDevice = noClasses()
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage(
                    "org.evoloop.line..",
                    "org.evoloop.link..",
                    "org.evoloop.serial..",
                    "org.evoloop.gpio..",
                    "org.evoloop.http..",
                    "org.evoloop.roomba..");
}
