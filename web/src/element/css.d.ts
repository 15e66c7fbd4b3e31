/** Style sheets as texts. */
declare module "*.css";
