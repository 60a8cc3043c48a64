package org.evoloop.device;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.belongToAnyOf;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** What the rooms of device files may use. */
@AnalyzeClasses(packages = "org.evoloop.device", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule theTextOfAFileKnowsNoDevice = noClasses()
            .that()
            .resideInAPackage("org.evoloop.device.file..")
            .should()
            .dependOnClassesThat()
            .resideOutsideOfPackages(
                    "org.evoloop.device.file..",
                    "org.evoloop.config..",
                    "org.evoloop.payload..",
                    "org.evoloop.statemachine..",
                    "org.snakeyaml..",
                    "org.jspecify..",
                    "java..");

    @ArchTest
    static final ArchRule aFileIsWiringAndReadsNoYamlItself = noClasses()
            .that()
            .resideInAnyPackage("org.evoloop.device", "org.evoloop.device.connection")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("org.snakeyaml..", "java.net..", "java.lang.Thread..");

    @ArchTest
    static final ArchRule noKindOfConnectionIsKnownByName = noClasses()
            .that()
            .resideInAPackage("org.evoloop.device")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("org.evoloop.device.connection");

    @ArchTest
    static final ArchRule aKindUsesOnlyWhatEveryKindCan = noClasses()
            .that()
            .resideInAPackage("org.evoloop.device.connection")
            .should()
            .dependOnClassesThat(resideInAPackage("org.evoloop.device")
                    .and(not(belongToAnyOf(
                            Connection.class, ConnectionKind.class, FileModels.class, Outward.class, Parts.class))));
}
