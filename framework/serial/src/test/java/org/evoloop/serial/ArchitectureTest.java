package org.evoloop.serial;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideOutsideOfPackages;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** What the serial module may use. */
@AnalyzeClasses(packages = "org.evoloop.serial", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule noDeviceIsKnown = noClasses()
            .should()
            .dependOnClassesThat(resideInAPackage("org.evoloop..")
                    .and(resideOutsideOfPackages("org.evoloop.serial..", "org.evoloop.line..", "org.evoloop.link..")));
}
