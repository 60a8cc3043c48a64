package org.evoloop.config;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** What the config module may use. */
@AnalyzeClasses(packages = "org.evoloop.config", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule itKnowsNothingOfConverters = classes()
            .should()
            .onlyDependOnClassesThat()
            .resideInAnyPackage(
                    "org.evoloop.config",
                    "org.evoloop.statemachine",
                    "org.snakeyaml..",
                    "org.jspecify..",
                    "picocli..",
                    "java..",
                    "javax.net.ssl..");

    @ArchTest
    static final ArchRule oneClassKnowsTheYamlLibrary = noClasses()
            .that()
            .doNotHaveSimpleName("ConfigFile")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("org.snakeyaml..");
}
