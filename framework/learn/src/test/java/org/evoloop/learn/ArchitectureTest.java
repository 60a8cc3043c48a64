package org.evoloop.learn;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** What the parts of learning may use. */
@AnalyzeClasses(packages = "org.evoloop.learn", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule onlyThePortKnowsConverters = noClasses()
            .that()
            .doNotHaveSimpleName("ConverterDevice")
            .and()
            .doNotHaveSimpleName("LookExecute")
            .and()
            .doNotHaveSimpleName("OnceAnalyze")
            .and()
            .resideInAPackage("org.evoloop.learn")
            .and()
            .areTopLevelClasses()
            .should()
            .dependOnClassesThat()
            .resideInAPackage("org.evoloop.converter..");

    @ArchTest
    static final ArchRule timeComesFromTheClock = noClasses()
            .should()
            .callMethod(System.class, "nanoTime")
            .orShould()
            .callMethod(System.class, "currentTimeMillis");
}
