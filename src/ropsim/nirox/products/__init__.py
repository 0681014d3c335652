"""Plain files of AP242: products and kinematics of any system, read as an arm and written from one."""
